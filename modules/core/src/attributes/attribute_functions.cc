#include "whittle/core/attribute_functions.hh"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "whittle/core/attribute_blend.hh"
#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// A linear function has four numbers; with twice as many points it is hardly linear by chance.
constexpr std::size_t least_points = 8;
/// Largest distance of a number of a linear chart from its function, over its range: rounding to four digits.
constexpr double most_apart = 1e-4;

bool has_unit_length(AttributeKind kind) { return kind == AttributeKind::normal || kind == AttributeKind::tangent; }

/// Per wedge, the first wedge of its vertex with the same value.
std::vector<Index> first_equal_wedges(const IndexedMesh& mesh, std::span<const double> values,
                                      std::size_t n_components) {
  const auto value = [&](Index w) { return values.subspan(w * n_components, n_components); };
  std::vector<Index> firsts(values.size() / n_components);
  std::iota(firsts.begin(), firsts.end(), Index{0});
  const detail::IndexLists<Index> wedges = wedges_of_vertices(mesh);
  for (Index v = 0; v < wedges.size(); ++v) {
    const std::span<const Index> of = wedges.of(v);
    for (const Index w : of) {
      const auto is_equal = [&](Index a) { return std::equal(value(a).begin(), value(a).end(), value(w).begin()); };
      const auto first = std::find_if(of.begin(), of.end(), is_equal);
      if (first != of.end()) firsts[w] = *first;  // a NaN equals nothing
    }
  }
  return firsts;
}

/// \param firsts as `first_equal_wedges` has them
std::vector<Index> charts_of(const IndexedMesh& mesh, const std::vector<Index>& firsts) {
  std::vector<Index> charts(firsts.size());
  detail::DisjointSets<Index> sets(charts.size());
  for (Index w = 0; w < charts.size(); ++w) sets.join(w, firsts[w]);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 1; k < 3; ++k) sets.join(mesh.wedge(f, 0), mesh.wedge(f, k));
  }
  for (Index w = 0; w < charts.size(); ++w) charts[w] = sets.find(w);
  return charts;
}

/// Charts numbered from 0 on, per wedge, and their number.
std::pair<std::vector<Index>, Index> numbered(const std::vector<Index>& charts) {
  std::vector<Index> numbers(charts.size(), invalid_index);
  std::vector<Index> of_wedges(charts.size(), invalid_index);
  Index n = 0;
  for (Index w = 0; w < charts.size(); ++w) {
    if (charts[w] == invalid_index) continue;
    if (numbers[charts[w]] == invalid_index) numbers[charts[w]] = n++;
    of_wedges[w] = numbers[charts[w]];
  }
  return {of_wedges, n};
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double number) {
    low = std::min(low, number);
    high = std::max(high, number);
  }
};

}  // namespace

std::vector<Index> attribute_charts(const IndexedMesh& mesh, std::span<const double> values, std::size_t n_components) {
  return charts_of(mesh, first_equal_wedges(mesh, values, n_components));
}

AttributeFunctions::AttributeFunctions(const LocalFunctions& functions, AttributeKind kind, std::size_t n_components,
                                       std::span<const double> values, unsigned threads)
    : functions_(functions),
      kind_(kind),
      n_components_(n_components),
      n_linear_(whittle::n_linear(kind, n_components)),
      values_(values),
      chart_of_(functions.n_wedges(), invalid_index) {
  if (n_linear_ > 0 && !has_unit_length(kind)) find_linear_charts(find_charts(), threads);
}

/// \return the chart of each wedge of the input; `invalid_index` if it has less than `least_points`
std::vector<Index> AttributeFunctions::find_charts() const {
  const std::vector<Index> firsts = first_equal_wedges(functions_.input(), values_, n_components_);
  std::vector<Index> charts = charts_of(functions_.input(), firsts);
  std::vector<std::size_t> n_points(charts.size());
  for (Index w = 0; w < charts.size(); ++w) n_points[charts[w]] += firsts[w] == w ? 1 : 0;
  for (Index& chart : charts) {
    if (n_points[chart] < least_points) chart = invalid_index;
  }
  return charts;
}

/// \param charts as of `find_charts`
void AttributeFunctions::find_linear_charts(std::vector<Index> charts, unsigned threads) {
  drop_bent_charts(charts);
  const auto [of_wedges, n_charts] = numbered(charts);
  if (n_charts == 0) return;
  const LocalFunctions of_charts(functions_.input(), functions_.frame(), of_wedges, n_charts, threads);
  charts_.resize(n_charts * n_linear_);
  for_each_range(n_charts, threads, [&](std::size_t begin, std::size_t end) {
    for (auto chart = static_cast<Index>(begin); chart < end; ++chart) {
      if (of_charts.any(chart)) find_chart(of_charts, chart);
    }
  });
  for (Index w = 0; w < of_wedges.size(); ++w) {
    const Index become = functions_.wedge_map()[w];
    if (become != invalid_index && of_wedges[w] != invalid_index) chart_of_[become] = of_wedges[w];
  }
}

void AttributeFunctions::find_chart(const LocalFunctions& charts, Index chart) {
  const std::vector<LocalFunction> functions =
      charts.around(chart, n_linear_, [&](Index wedge, std::size_t i) { return number(wedge, i); });
  for (std::size_t i = 0; i < n_linear_; ++i) {
    const LocalFunction& function = functions[i];
    if (!function.is_linear) continue;
    const double most = most_apart * (function.high - function.low);
    bool is_linear = true;
    charts.for_each_corner(chart, [&](Index wedge, const Vec3& position) {
      is_linear = is_linear && std::abs(function.at(position) - number(wedge, i)) <= most;
    });
    charts_[chart * n_linear_ + i] = {is_linear, function};
  }
}

/// Most charts are not linear, and a few of their points tell: if a function was `most_apart` from none of the chart's
/// numbers, the best one for these points would leave no more than that. Rounding decides nothing: a chart that is left
/// is looked at as a whole.
void AttributeFunctions::drop_bent_charts(std::vector<Index>& charts) const {
  constexpr std::size_t n_sampled = 64;  // about so many wedges of a chart
  const auto [of_wedges, n_charts] = numbered(charts);
  std::vector<std::size_t> n_points(n_charts);
  std::vector<Range> ranges(n_charts * n_linear_);
  for (Index w = 0; w < of_wedges.size(); ++w) {
    const Index chart = of_wedges[w];
    if (chart == invalid_index) continue;
    ++n_points[chart];
    for (std::size_t i = 0; i < n_linear_; ++i) ranges[chart * n_linear_ + i].add(number(w, i));
  }
  const std::vector<Index> vertices = vertices_of_wedges(functions_.input());
  const auto vertex_of = [&](Index w) { return vertices.empty() ? w : vertices[w]; };
  std::vector<std::vector<Index>> samples(n_charts);
  std::vector<std::size_t> places(n_charts);
  for (Index w = 0; w < of_wedges.size(); ++w) {
    const Index chart = of_wedges[w];
    const bool is_used = chart != invalid_index && vertex_of(w) != invalid_index;
    if (is_used && places[chart]++ % (n_points[chart] / n_sampled + 1) == 0) samples[chart].push_back(w);
  }
  const auto is_bent = [&](Index chart) {
    const std::vector<Index>& sample = samples[chart];
    const auto n = static_cast<Eigen::Index>(sample.size());
    Eigen::MatrixX4d points(n, 4);
    Eigen::MatrixXd numbers(n, static_cast<Eigen::Index>(n_linear_));
    for (Eigen::Index k = 0; k < n; ++k) {
      const Index w = sample[static_cast<std::size_t>(k)];
      points.row(k) << functions_.frame().to_frame(functions_.input().positions[vertex_of(w)]).transpose(), 1;
      for (std::size_t i = 0; i < n_linear_; ++i) numbers(k, static_cast<Eigen::Index>(i)) = number(w, i);
    }
    const Eigen::MatrixXd left = points * points.colPivHouseholderQr().solve(numbers) - numbers;
    for (std::size_t i = 0; i < n_linear_; ++i) {
      const Range& range = ranges[chart * n_linear_ + i];
      if (!(range.high > range.low)) continue;                        // local functions are constant, too
      const double most = 2 * most_apart * (range.high - range.low);  // with a margin for rounding
      if (!(left.col(static_cast<Eigen::Index>(i)).squaredNorm() > static_cast<double>(n) * most * most)) return false;
    }
    return true;
  };
  std::vector<std::uint8_t> bent(n_charts);
  for (Index chart = 0; chart < n_charts; ++chart) bent[chart] = is_bent(chart) ? 1 : 0;
  for (Index w = 0; w < charts.size(); ++w) {
    if (of_wedges[w] != invalid_index && bent[of_wedges[w]] != 0) charts[w] = invalid_index;
  }
}

std::vector<LocalFunction> AttributeFunctions::of(Index w) const {
  std::vector<LocalFunction> all =
      functions_.around(w, n_linear_, [&](Index wedge, std::size_t i) { return number(wedge, i); });
  for (std::size_t i = 0; i < n_linear_; ++i) {
    LocalFunction& local = all[i];
    const Chart chart = chart_of_[w] == invalid_index ? Chart{} : charts_[chart_of_[w] * n_linear_ + i];
    if (!chart.is_linear) {
      local.stays = true;  // a step is linear, too, where few points are around
      continue;
    }
    const auto [low, high] = std::pair(local.low, local.high);
    local = chart.function;
    local.low = low;
    local.high = high;
  }
  return all;
}

/// Each joint's weight is a separate number. The greatest weights that fit into a value are kept.
void AttributeFunctions::move_joint_weights(Index w, const Vec3& position, std::span<double> value) const {
  const std::size_t k = value.size() / 2;
  std::vector<double> joints;
  const auto joint_at = [&](Index wedge, std::size_t i) { return number(wedge, i); };
  const auto weight_at = [&](Index wedge, std::size_t i) { return number(wedge, k + i); };
  functions_.for_each_corner(w, [&](Index wedge, const Vec3&) {
    for (std::size_t i = 0; i < k; ++i) {
      if (weight_at(wedge, i) > 0) joints.push_back(joint_at(wedge, i));
    }
  });
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  const auto weight_of = [&](Index wedge, std::size_t j) {
    double sum = 0;
    for (std::size_t i = 0; i < k; ++i) sum += joint_at(wedge, i) == joints[j] ? weight_at(wedge, i) : 0;
    return sum;
  };
  const std::vector<LocalFunction> functions = functions_.around(w, joints.size(), weight_of);
  std::vector<std::array<double, 2>> moved;  // weight, joint
  for (std::size_t j = 0; j < joints.size(); ++j) {
    moved.push_back({std::max(0.0, functions[j].in_range(functions[j].at(position), position)), joints[j]});
  }
  std::stable_sort(moved.begin(), moved.end(), [](const auto& a, const auto& b) { return a[0] > b[0]; });
  moved.resize(std::min(k, moved.size()));
  double before = 0;
  double after = 0;
  for (std::size_t i = 0; i < k; ++i) before += value[k + i];
  for (const auto& [weight, joint] : moved) after += weight;
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
