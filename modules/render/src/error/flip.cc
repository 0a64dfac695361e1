// Andersson et al., "FLIP: A Difference Evaluator for Alternating Images" (2020). Comments have the names that the
// paper gives its stages.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "error/colors.hh"
#include "error/planes.hh"
#include "whittle/render/picture_error.hh"
#include "whittle/render/srgb.hh"

namespace whittle::render {

namespace {

constexpr double pi = std::numbers::pi;

using ThreePlanes = std::array<Plane, 3>;

ThreePlanes opponent_planes(const Picture& picture) {
  const Plane empty(picture.width, picture.height);
  ThreePlanes planes = {empty, empty, empty};
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    Triple light{};
    for (std::size_t k = 0; k < 3; ++k) light[k] = linear_of_srgb(std::clamp(picture.pixels[i][k], 0.0F, 1.0F));
    const Triple opponent = opponent_of_linear(light);
    for (std::size_t k = 0; k < 3; ++k) planes[k].values[i] = opponent[k];
  }
  return planes;
}

// Spatial filtering: details that the eye can't resolve are blurred, colours more than lightness. ---------------------

/// One term of a contrast sensitivity function in space, a · √(π/b) · exp(-π² x²/b), x in degrees.
struct Gaussian {
  double a;
  double b;
};
constexpr Gaussian achromatic = {1, 0.0047};
constexpr Gaussian red_green = {1, 0.0053};
constexpr Gaussian blue_yellow_narrow = {34.1, 0.04};
constexpr Gaussian blue_yellow_wide = {13.5, 0.025};

/// Three standard deviations of the widest term; one radius for all channels.
int sensitivity_radius(double pixels_per_degree) {
  return static_cast<int>(std::ceil(3 * std::sqrt(blue_yellow_narrow.b / (2 * pi * pi)) * pixels_per_degree));
}

/// A Gaussian along one axis, with sum 1. \param sum the sum before
Kernel gaussian_kernel(const Gaussian& term, double pixels_per_degree, double& sum) {
  const int r = sensitivity_radius(pixels_per_degree);
  std::vector<double> weights;
  sum = 0;
  for (int i = -r; i <= r; ++i) {
    const double x = i / pixels_per_degree;
    weights.push_back(std::exp(-pi * pi * x * x / term.b));
    sum += weights.back();
  }
  Kernel kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

/// Blurred by one term of two dimensions, which is a product of two of one. \param volume of the term
Plane blurred(const Plane& plane, const Gaussian& term, double pixels_per_degree, double& volume) {
  double sum = 0;
  const Kernel kernel = gaussian_kernel(term, pixels_per_degree, sum);
  volume = term.a * std::sqrt(pi / term.b) * sum * sum;
  return filtered(plane, kernel, kernel);
}

/// Blue-yellow has two terms. Their weights are their volumes.
Plane blurred_blue_yellow(const Plane& plane, double pixels_per_degree) {
  double narrow_volume = 0;
  double wide_volume = 0;
  Plane narrow = blurred(plane, blue_yellow_narrow, pixels_per_degree, narrow_volume);
  const Plane wide = blurred(plane, blue_yellow_wide, pixels_per_degree, wide_volume);
  const auto share = static_cast<float>(narrow_volume / (narrow_volume + wide_volume));
  for (std::size_t i = 0; i < narrow.values.size(); ++i) {
    narrow.values[i] = share * narrow.values[i] + (1 - share) * wide.values[i];
  }
  return narrow;
}

/// The picture as perceived by the eye, in CIELAB.
std::vector<Triple> perceived_colors(const ThreePlanes& planes, double pixels_per_degree) {
  double volume = 0;  // of a single term: it has all the weight
  const ThreePlanes seen = {blurred(planes[0], achromatic, pixels_per_degree, volume),
                            blurred(planes[1], red_green, pixels_per_degree, volume),
                            blurred_blue_yellow(planes[2], pixels_per_degree)};
  std::vector<Triple> colors(seen[0].values.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    Triple light = linear_of_opponent({seen[0].values[i], seen[1].values[i], seen[2].values[i]});
    for (float& channel : light) channel = std::clamp(channel, 0.0F, 1.0F);
    colors[i] = hunt_lab_of_linear(light);
  }
  return colors;
}

// Color metric and error redistribution: the distance of two colours, brought to [0, 1]. ------------------------------

constexpr float color_exponent = 0.7F;
/// Up to this share of the greatest distance, distances take `compressed_range` of [0, 1].
constexpr float compressed_share = 0.4F;
constexpr float compressed_range = 0.95F;

float compressed(float distance) { return std::pow(distance, color_exponent); }

/// The compressed distance of green and blue, the greatest one.
float largest_distance() { return compressed(hyab(hunt_lab_of_linear({0, 1, 0}), hunt_lab_of_linear({0, 0, 1}))); }

float color_error(const Triple& a, const Triple& b, float largest) {
  const float distance = compressed(hyab(a, b));
  const float knee = compressed_share * largest;
  if (distance < knee) return distance * compressed_range / knee;
  return std::min(compressed_range + (distance - knee) / (largest - knee) * (1 - compressed_range), 1.0F);
}

// Feature pipeline: edges and points that only one picture has. -------------------------------------------------------

constexpr double feature_width_deg = 0.082;

/// Divides by the sum of the positive weights, and the negative ones by theirs: both sides have sum 1.
Kernel balanced(const std::vector<double>& weights) {
  double positive = 0;
  double negative = 0;
  for (const double weight : weights) (weight > 0 ? positive : negative) += std::abs(weight);
  Kernel kernel;
  for (const double weight : weights) {
    kernel.push_back(static_cast<float>(weight == 0 ? 0 : weight / (weight > 0 ? positive : negative)));
  }
  return kernel;
}

/// A Gaussian and its two derivatives, along one axis.
struct FeatureKernels {
  Kernel smooth;
  Kernel edge;
  Kernel point;
};

FeatureKernels feature_kernels(double pixels_per_degree) {
  const double sigma = 0.5 * feature_width_deg * pixels_per_degree;
  const int r = static_cast<int>(std::ceil(3 * sigma));
  std::vector<double> smooth;
  std::vector<double> edge;
  std::vector<double> point;
  for (int x = -r; x <= r; ++x) {
    const double weight = std::exp(-x * x / (2 * sigma * sigma));
    smooth.push_back(weight);
    edge.push_back(-x * weight);
    point.push_back((x * x / (sigma * sigma) - 1) * weight);
  }
  return {balanced(smooth), balanced(edge), balanced(point)};
}

/// How strong a feature is at each pixel: the length of its two directions.
Plane strength(const Plane& luminance, const Kernel& feature, const Kernel& smooth) {
  Plane along_x = filtered(luminance, feature, smooth);
  const Plane along_y = filtered(luminance, smooth, feature);
  for (std::size_t i = 0; i < along_x.values.size(); ++i) {
    const float x = along_x.values[i];
    const float y = along_y.values[i];
    along_x.values[i] = std::sqrt(x * x + y * y);
  }
  return along_x;
}

struct Features {
  Plane edges;
  Plane points;
};

Features features_of(Plane achromatic_plane, const FeatureKernels& kernels) {
  for (float& value : achromatic_plane.values) value = luminance_of_achromatic(value);
  return {strength(achromatic_plane, kernels.edge, kernels.smooth),
          strength(achromatic_plane, kernels.point, kernels.smooth)};
}

float feature_error(const Features& a, const Features& b, std::size_t i) {
  const float edges = std::abs(a.edges.values[i] - b.edges.values[i]);
  const float points = std::abs(a.points.values[i] - b.points.values[i]);
  return std::min(std::sqrt(std::max(edges, points) / std::numbers::sqrt2_v<float>), 1.0F);
}

void check(const Picture& a, const Picture& b, double pixels_per_degree) {
  if (a.width != b.width || a.height != b.height) throw std::invalid_argument("pictures to compare differ in size");
  if (a.pixels.empty() || a.pixels.size() != a.width * a.height || b.pixels.size() != a.pixels.size()) {
    throw std::invalid_argument("a picture to compare has no pixels, or fewer than its size says");
  }
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000)) {
    throw std::invalid_argument("FLIP's pixels per degree must be in [1, 1000]");
  }
}

}  // namespace

ErrorMap flip_map(const Picture& a, const Picture& b, double pixels_per_degree) {
  check(a, b, pixels_per_degree);
  const ThreePlanes opponent_a = opponent_planes(a);
  const ThreePlanes opponent_b = opponent_planes(b);
  const std::vector<Triple> colors_a = perceived_colors(opponent_a, pixels_per_degree);
  const std::vector<Triple> colors_b = perceived_colors(opponent_b, pixels_per_degree);
  const FeatureKernels kernels = feature_kernels(pixels_per_degree);
  const Features features_a = features_of(opponent_a[0], kernels);
  const Features features_b = features_of(opponent_b[0], kernels);
  const float largest = largest_distance();
  ErrorMap map{a.width, a.height, std::vector<float>(a.pixels.size())};
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    // Final difference: a feature that differs makes a colour's difference count for more.
    map.values[i] =
        std::pow(color_error(colors_a[i], colors_b[i], largest), 1 - feature_error(features_a, features_b, i));
  }
  return map;
}

double ErrorMap::mean() const {
  double sum = 0;
  for (const float value : values) sum += static_cast<double>(value);
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double flip(const Picture& a, const Picture& b, double pixels_per_degree) {
  return flip_map(a, b, pixels_per_degree).mean();
}

}  // namespace whittle::render
