#include "image/resolve.hh"

#include "image/srgb.hh"
#include "whittle/render/draw.hh"

namespace whittle::render {

namespace {

/// The mean of red, green, blue and coverage over the samples of a pixel. \param corner its first number
std::array<float, 4> mean_of_samples(const float* corner, std::size_t row_length, std::size_t grid) {
  std::array<float, 4> sum{};
  for (std::size_t y = 0; y < grid; ++y) {
    for (std::size_t x = 0; x < grid; ++x) {
      for (std::size_t i = 0; i < 4; ++i) sum[i] += corner[y * row_length + 4 * x + i];
    }
  }
  for (float& number : sum) number /= static_cast<float>(grid * grid);
  return sum;
}

}  // namespace

float background_light() { return linear_of_srgb(background); }

Picture resolve(const std::vector<float>& samples, std::size_t size, std::size_t grid) {
  Picture picture{size, size, std::vector<Rgb>(size * size), std::vector<float>(size * size)};
  const std::size_t row_length = 4 * size * grid;
  for (std::size_t y = 0; y < size; ++y) {
    const float* const row = samples.data() + (size - 1 - y) * grid * row_length;
    for (std::size_t x = 0; x < size; ++x) {
      const std::array<float, 4> mean = mean_of_samples(row + 4 * x * grid, row_length, grid);
      Rgb& pixel = picture.pixels[y * size + x];
      for (std::size_t i = 0; i < 3; ++i) pixel[i] = static_cast<float>(srgb8_of_linear(mean[i])) / 255;
      picture.coverage[y * size + x] = mean[3];
    }
  }
  return picture;
}

}  // namespace whittle::render
