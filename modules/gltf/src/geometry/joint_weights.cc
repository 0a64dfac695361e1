#include "geometry/joint_weights.hh"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace whittle::gltf {
namespace {

/// Tolerance of the sum of weights, per weight: the validator's limit.
constexpr double sum_tolerance = 2e-7;

}  // namespace

JointWeights kept_joints(std::span<const double> value, std::size_t n) {
  const std::size_t k = value.size() / 2;
  const std::span<const double> all_weights = value.subspan(k);
  std::vector<std::size_t> order(k);
  std::iota(order.begin(), order.end(), std::size_t{0});
  const bool all_fit = std::all_of(order.begin(), order.end(), [&](auto i) { return i < n || all_weights[i] == 0; });
  if (!all_fit) {
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return all_weights[a] > all_weights[b]; });
  }
  order.resize(std::min(n, k));
  JointWeights kept;
  for (const std::size_t i : order) {
    kept.joints.push_back(value[i]);
    kept.weights.push_back(std::max(all_weights[i], 0.0));
  }
  const double sum = std::accumulate(kept.weights.begin(), kept.weights.end(), 0.0);
  if (sum > 0 && std::abs(sum - 1) > sum_tolerance) {
    for (double& weight : kept.weights) weight /= sum;
  }
  return kept;
}

void round_weights(std::span<double> weights, double largest) {
  const double sum = std::round(std::accumulate(weights.begin(), weights.end(), 0.0) * largest);
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> rests(weights.size());
  double left = sum;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    // A product that should be whole may be a little below it.
    const double scaled = weights[i] * largest;
    const double low = std::abs(scaled - std::round(scaled)) < 1e-6 ? std::round(scaled) : std::floor(scaled);
    rests[i] = scaled - low;
    weights[i] = low;
    left -= low;
  }
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return rests[a] > rests[b]; });
  for (std::size_t i = 0; i < order.size() && left > 0; ++i, --left) ++weights[order[i]];
  for (std::size_t i = order.size(); i-- > 0 && left < 0;) {
    if (weights[order[i]] > 0) --weights[order[i]], ++left;
  }
  for (double& weight : weights) weight /= largest;
}

}  // namespace whittle::gltf
