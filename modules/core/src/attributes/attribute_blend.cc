#include "whittle/core/attribute_blend.hh"

#include <algorithm>
#include <cmath>

namespace whittle {
namespace {

constexpr double least_mean = 1e-3;  // below that the mean of unit vectors has no direction to speak of

bool is_direction(AttributeKind kind) { return kind == AttributeKind::normal || kind == AttributeKind::tangent; }

double length_of(std::span<const double> direction) {
  return std::sqrt(direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2]);
}

}  // namespace

std::size_t n_linear(AttributeKind kind, std::size_t n_components) {
  if (kind == AttributeKind::category || kind == AttributeKind::joint_weights) return 0;
  return kind == AttributeKind::tangent ? std::min<std::size_t>(n_components, 3) : n_components;
}

void restore_range(AttributeKind kind, std::span<const double> before, std::span<double> value) {
  if (kind == AttributeKind::color) {
    for (double& x : value) x = std::clamp(x, 0.0, 1.0);
  } else if (is_direction(kind)) {
    const double length = length_of(value);
    for (std::size_t i = 0; i < 3; ++i) value[i] = length > least_mean ? value[i] / length : before[i];
  }
}

AttributeBlend::AttributeBlend(AttributeKind kind, std::size_t n_components) : kind_(kind), sum_(n_components) {}

void AttributeBlend::vote(double what, double weight, std::span<const double> value) {
  const auto found = std::find_if(votes_.begin(), votes_.end(), [&](const Vote& v) {
    return v.what == what &&
           (kind_ != AttributeKind::category || std::equal(value.begin(), value.end(), v.value.begin()));
  });
  if (found != votes_.end()) {
    found->weight += weight;
  } else {
    votes_.push_back({what, weight, {value.begin(), value.end()}});
  }
}

void AttributeBlend::add(std::span<const double> value, double weight) {
  ++n_;
  total_ += weight;
  last_.assign(value.begin(), value.end());
  if (kind_ == AttributeKind::category) {
    vote(value[0], weight, value);
  } else if (kind_ == AttributeKind::joint_weights) {
    const std::size_t k = value.size() / 2;
    for (std::size_t i = 0; i < k; ++i) {
      if (value[k + i] > 0) vote(value[i], weight * value[k + i], {});
    }
  } else {
    for (std::size_t i = 0; i < value.size(); ++i) sum_[i] += weight * value[i];
    if (kind_ == AttributeKind::tangent && value.size() == 4) vote(value[3], weight, {});
  }
}

/// Blends normals, or tangents with the sign of the majority.
bool AttributeBlend::direction(std::span<double> to) const {
  const double length = length_of(sum_);
  if (!(length >= least_mean * total_)) return false;
  for (std::size_t i = 0; i < 3; ++i) to[i] = sum_[i] / length;
  if (to.size() == 4) to[3] = votes_.front().what;
  return true;
}

/// Keeps the greatest weights that fit into a value, scaled to the sum of all.
void AttributeBlend::joint_weights(std::span<double> to) {
  const std::size_t k = to.size() / 2;
  const std::size_t n_kept = std::min(k, votes_.size());
  double kept = 0;
  double all = 0;
  for (const Vote& v : votes_) all += v.weight;
  for (std::size_t i = 0; i < n_kept; ++i) kept += votes_[i].weight;
  const double scale = kept > 0 ? all / kept / total_ : 0;
  for (std::size_t i = 0; i < k; ++i) {
    to[i] = i < n_kept ? votes_[i].what : 0;
    to[k + i] = i < n_kept ? votes_[i].weight * scale : 0;
  }
}

void AttributeBlend::forget() {
  std::fill(sum_.begin(), sum_.end(), 0.0);
  total_ = 0;
  n_ = 0;
  votes_.clear();
}

bool AttributeBlend::result(std::span<double> to) {
  bool is_there = true;
  std::stable_sort(votes_.begin(), votes_.end(), [](const Vote& a, const Vote& b) { return a.weight > b.weight; });
  if (n_ == 1) {
    std::copy(last_.begin(), last_.end(), to.begin());
  } else if (kind_ == AttributeKind::category) {
    std::copy(votes_.front().value.begin(), votes_.front().value.end(), to.begin());
  } else if (kind_ == AttributeKind::joint_weights) {
    joint_weights(to);
  } else if (is_direction(kind_)) {
    is_there = direction(to);
  } else {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = sum_[i] / total_;
  }
  forget();
  return is_there;
}

}  // namespace whittle
