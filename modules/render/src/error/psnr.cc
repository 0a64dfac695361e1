#include <cmath>
#include <limits>
#include <stdexcept>

#include "whittle/render/picture_error.hh"

namespace whittle::render {

namespace {

bool shows_model(const Picture& picture, std::size_t pixel) {
  return picture.coverage.empty() || picture.coverage[pixel] > 0;
}

}  // namespace

SquaredError& SquaredError::operator+=(const SquaredError& other) {
  sum += other.sum;
  size += other.size;
  return *this;
}

double SquaredError::psnr() const {
  if (!(sum > 0)) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(255.0 * 255.0 * static_cast<double>(size) / sum);
}

SquaredError squared_error(const Picture& a, const Picture& b, PixelSet pixels) {
  if (a.width != b.width || a.height != b.height) throw std::invalid_argument("pictures to compare differ in size");
  SquaredError error;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (pixels == PixelSet::model && !shows_model(a, i) && !shows_model(b, i)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference = 255 * (static_cast<double>(a.pixels[i][k]) - static_cast<double>(b.pixels[i][k]));
      error.sum += difference * difference;
    }
    error.size += 3;
  }
  return error;
}

double psnr(const Picture& a, const Picture& b, PixelSet pixels) { return squared_error(a, b, pixels).psnr(); }

}  // namespace whittle::render
