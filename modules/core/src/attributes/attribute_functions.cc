#include "whittle/core/attribute_functions.hh"

#include <algorithm>
#include <cmath>
#include <utility>

#include "attributes/linear_charts.hh"
#include "whittle/core/attribute_blend.hh"

namespace whittle {
namespace {

bool has_unit_length(AttributeKind kind) { return kind == AttributeKind::normal || kind == AttributeKind::tangent; }

/// So many maps are compared with others.
constexpr std::size_t most_maps = 64;

/// Whether functions differ by whole numbers, up to rounding.
bool are_of_one_map(std::span<const LocalFunction> a, std::span<const LocalFunction> b) {
  constexpr double rounding = 1e-3;  // of a texture's unit
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double apart = a[i].at(b[i].center) - b[i].mean;
    const double most = rounding * a[i].slope.cwiseAbs().maxCoeff();
    if (!(std::abs(apart - std::round(apart)) <= rounding)) return false;
    if (!((a[i].slope - b[i].slope).cwiseAbs().maxCoeff() <= most)) return false;
  }
  return true;
}

void make_unique(std::vector<double>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

AttributeFunctions::AttributeFunctions(const LocalFunctions& functions, AttributeKind kind, std::size_t n_components,
                                       std::span<const double> values, unsigned threads)
    : functions_(functions),
      kind_(kind),
      n_components_(n_components),
      n_linear_(whittle::n_linear(kind, n_components)),
      values_(values) {
  detail::AttributeNumbers numbers{values, n_components, n_linear_, {}, false};
  numbers.number = [this](Index wedge, std::size_t i) { return number(wedge, i); };
  if (kind == AttributeKind::joint_weights) {
    find_joints();
    numbers.n = joints_.size();
    numbers.number = [this](Index wedge, std::size_t i) { return weight_of(joints_[i], wedge); };
    numbers.need_all = true;
  }
  if (numbers.n == 0 || has_unit_length(kind)) return;
  auto [charts, in_charts] = detail::find_linear_charts(functions, numbers, threads);
  charts_ = std::move(charts);
  in_charts_ = std::move(in_charts);
}

double AttributeFunctions::weight_of(double joint, Index wedge) const {
  const std::size_t k = n_components_ / 2;
  double sum = 0;
  for (std::size_t i = 0; i < k; ++i) sum += number(wedge, i) == joint ? number(wedge, k + i) : 0;
  return sum;
}

void AttributeFunctions::find_joints() {
  const std::size_t k = n_components_ / 2;
  for (Index w = 0; w < values_.size() / n_components_; ++w) {
    for (std::size_t i = 0; i < k; ++i) {
      const bool is_last = !joints_.empty() && joints_.back() == number(w, i);
      if (number(w, k + i) > 0 && !is_last) joints_.push_back(number(w, i));
    }
  }
  make_unique(joints_);
}

/// The functions of the chart that w lies in; empty if it is not linear.
std::span<const LocalFunction> AttributeFunctions::chart_of(Index w) const {
  if (in_charts_.empty() || charts_[w] == invalid_index) return {};
  const std::size_t n = kind_ == AttributeKind::joint_weights ? joints_.size() : n_linear_;
  return std::span(in_charts_).subspan(charts_[w] * n, n);
}

std::vector<Index> AttributeFunctions::maps() const {
  std::vector<Index> maps(functions_.n_wedges(), invalid_index);
  if (in_charts_.empty()) return maps;
  const auto chart = [this](Index i) { return std::span(in_charts_).subspan(i * n_linear_, n_linear_); };
  std::vector<Index> of_charts(in_charts_.size() / n_linear_, invalid_index);
  std::vector<Index> firsts;
  for (Index i = 0; i < of_charts.size(); ++i) {
    const auto holds = [](const LocalFunction& function) { return function.holds; };
    if (!std::all_of(chart(i).begin(), chart(i).end(), holds)) continue;
    const auto same =
        std::find_if(firsts.begin(), firsts.end(), [&](Index k) { return are_of_one_map(chart(k), chart(i)); });
    of_charts[i] = same == firsts.end() ? i : *same;
    if (same == firsts.end() && firsts.size() < most_maps) firsts.push_back(i);
  }
  for (Index w = 0; w < maps.size(); ++w) {
    if (charts_[w] != invalid_index) maps[w] = of_charts[charts_[w]];
  }
  return maps;
}

std::vector<LocalFunction> AttributeFunctions::of(Index w) const {
  std::vector<LocalFunction> all =
      functions_.around(w, n_linear_, [&](Index wedge, std::size_t i) { return number(wedge, i); });
  const std::span<const LocalFunction> in_chart = chart_of(w);
  for (std::size_t i = 0; i < n_linear_ && !in_chart.empty(); ++i) {
    if (!in_chart[i].holds) continue;
    const auto [low, high] = std::pair(all[i].low, all[i].high);
    all[i] = in_chart[i];
    all[i].low = low;
    all[i].high = high;
  }
  return all;
}

/// Weights and joints at a position near w, the greatest first.
std::vector<std::array<double, 2>> AttributeFunctions::joints_at(Index w, const Vec3& position) const {
  std::vector<std::array<double, 2>> found;
  const std::span<const LocalFunction> in_chart = chart_of(w);
  for (std::size_t j = 0; j < in_chart.size() && in_chart[j].holds; ++j) {
    found.push_back({in_chart[j].at(position), joints_[j]});
  }
  if (found.empty()) {
    const std::size_t k = n_components_ / 2;
    std::vector<double> joints;
    functions_.for_each_corner(w, [&](Index wedge, const Vec3&) {
      for (std::size_t i = 0; i < k; ++i) {
        if (number(wedge, k + i) > 0) joints.push_back(number(wedge, i));
      }
    });
    make_unique(joints);
    const std::vector<LocalFunction> functions =
        functions_.around(w, joints.size(), [&](Index wedge, std::size_t j) { return weight_of(joints[j], wedge); });
    for (std::size_t j = 0; j < joints.size(); ++j) {
      LocalFunction function = functions[j];
      function.holds = function.is_linear;
      found.push_back({function.in_range(function.at(position), position), joints[j]});
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a[0] > b[0]; });
  return found;
}

/// Each joint's weight is a separate number. The greatest weights that fit into a value are kept.
void AttributeFunctions::move_joint_weights(Index w, const Vec3& position, std::span<double> value) const {
  const std::size_t k = value.size() / 2;
  std::vector<std::array<double, 2>> moved = joints_at(w, position);
  moved.resize(std::min(k, moved.size()));
  double before = 0;
  double after = 0;
  for (std::size_t i = 0; i < k; ++i) before += value[k + i];
  for (const auto& [weight, joint] : moved) after += std::max(0.0, weight);
  if (!(after > 0)) return;
  for (std::size_t i = 0; i < k; ++i) {
    const bool is_there = i < moved.size() && moved[i][0] > 0;
    value[i] = is_there ? moved[i][1] : 0;
    value[k + i] = is_there ? moved[i][0] * (before / after) : 0;
  }
}

void AttributeFunctions::move(Index w, const Vec3& position, std::span<double> value) const {
  if (!any(w)) return;
  if (kind_ == AttributeKind::joint_weights) return move_joint_weights(w, position, value);
  const std::vector<double> before(value.begin(), value.end());
  const std::vector<LocalFunction> functions = of(w);
  for (std::size_t i = 0; i < n_linear_; ++i) {
    const LocalFunction& function = functions[i];
    const double moved = function.in_range(function.at(position), position);
    if (std::isfinite(moved)) value[i] = moved;
  }
  restore_range(kind_, before, value);
}

}  // namespace whittle
