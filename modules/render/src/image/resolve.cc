#include "image/resolve.hh"

#include "whittle/render/draw.hh"
#include "whittle/render/srgb.hh"

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

Picture resolve(const std::vector<float>& samples, const SampleGrid& grid, SampleColors colors) {
  const std::size_t n = grid.width * grid.height;
  Picture picture{grid.width, grid.height, std::vector<Rgb>(n), std::vector<float>(n)};
  const std::size_t row_length = 4 * grid.width * grid.side;
  for (std::size_t y = 0; y < grid.height; ++y) {
    const float* const row = samples.data() + (grid.height - 1 - y) * grid.side * row_length;
    for (std::size_t x = 0; x < grid.width; ++x) {
      const std::array<float, 4> mean = mean_of_samples(row + 4 * x * grid.side, row_length, grid.side);
      Rgb& pixel = picture.pixels[y * grid.width + x];
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint8_t byte = colors == SampleColors::linear ? srgb8_of_linear(mean[i]) : to_8_bits(mean[i]);
        pixel[i] = static_cast<float>(byte) / 255;
      }
      picture.coverage[y * grid.width + x] = mean[3];
    }
  }
  return picture;
}

}  // namespace whittle::render
