#include "error/colors.hh"

#include <cmath>

namespace whittle::render {

namespace {

// IEC 61966-2-1, from the chromaticities of primaries and white: light to CIE XYZ, and back.
constexpr std::array<std::array<float, 3>, 3> to_xyz = {{{0.41239080F, 0.35758434F, 0.18048079F},
                                                         {0.21263901F, 0.71516868F, 0.07219232F},
                                                         {0.01933082F, 0.11919478F, 0.95053215F}}};
constexpr std::array<std::array<float, 3>, 3> to_rgb = {{{3.24096994F, -1.53738318F, -0.49861076F},
                                                         {-0.96924364F, 1.87596750F, 0.04155506F},
                                                         {0.05563008F, -0.20397696F, 1.05697151F}}};
constexpr Triple white = {0.95045593F, 1.0F, 1.08905775F};

Triple times(const std::array<std::array<float, 3>, 3>& matrix, const Triple& v) {
  Triple product{};
  for (std::size_t i = 0; i < 3; ++i) product[i] = matrix[i][0] * v[0] + matrix[i][1] * v[1] + matrix[i][2] * v[2];
  return product;
}

/// CIE XYZ over white.
Triple relative_xyz(const Triple& rgb) {
  const Triple xyz = times(to_xyz, rgb);
  return {xyz[0] / white[0], xyz[1] / white[1], xyz[2] / white[2]};
}

/// CIELAB's curve: a cube root, and a line near 0.
float lab_curve(float t) {
  constexpr float delta = 6.0F / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0F / 29;
}

}  // namespace

Triple opponent_of_linear(const Triple& rgb) {
  const Triple t = relative_xyz(rgb);
  return {116 * t[1] - 16, 500 * (t[0] - t[1]), 200 * (t[1] - t[2])};
}

Triple linear_of_opponent(const Triple& opponent) {
  const float y = luminance_of_achromatic(opponent[0]);
  const float x = opponent[1] / 500 + y;
  const float z = y - opponent[2] / 200;
  return times(to_rgb, {x * white[0], y * white[1], z * white[2]});
}

float luminance_of_achromatic(float achromatic) { return (achromatic + 16) / 116; }

Triple hunt_lab_of_linear(const Triple& rgb) {
  const Triple t = relative_xyz(rgb);
  const float x = lab_curve(t[0]);
  const float y = lab_curve(t[1]);
  const float z = lab_curve(t[2]);
  const float lightness = 116 * y - 16;
  const float hunt = 0.01F * lightness;
  return {lightness, hunt * 500 * (x - y), hunt * 200 * (y - z)};
}

float hyab(const Triple& a, const Triple& b) {
  const float da = a[1] - b[1];
  const float db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

}  // namespace whittle::render
