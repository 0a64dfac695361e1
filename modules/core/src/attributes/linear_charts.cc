#include "attributes/linear_charts.hh"

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "attributes/attribute_charts.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/wedges.hh"

namespace whittle::detail {
namespace {

/// A linear function has four numbers; with twice as many points it is hardly linear by chance.
constexpr std::size_t least_points = 8;
/// Largest distance of a number of a linear chart from its function, over its range: rounding to four digits.
constexpr double most_apart = 1e-4;

/// What is known of a chart's number before its function.
struct Spread {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  std::size_t n_digits = 0;  ///< behind the point, at most; `all_digits` if there are many

  static constexpr std::array units{1.0, 1e1, 1e2, 1e3, 1e4};  ///< parts of one, by digits
  static constexpr std::size_t all_digits = units.size();

  void add(double number) {
    low = std::min(low, number);
    high = std::max(high, number);
    while (n_digits < all_digits && !is_whole(number * units[n_digits])) ++n_digits;
  }
  bool is_constant() const { return !(high > low); }
  /// How far a number may be from a linear function.
  double most() const {
    const double digit = n_digits < all_digits ? 1 / units[n_digits] : 0;
    return std::max(most_apart * (high - low), digit);
  }

 private:
  /// To single precision, in which files are often read.
  static bool is_whole(double number) { return std::abs(number - std::round(number)) <= 2e-7 * std::abs(number); }
};

class ChartFinder {
 public:
  ChartFinder(const LocalFunctions& functions, const AttributeNumbers& numbers, unsigned threads)
      : functions_(functions), numbers_(numbers), threads_(threads) {}

  LinearCharts find() {
    find_charts();
    drop_bent_charts();
    const Index n_charts = renumber();
    LinearCharts found{std::vector<Index>(functions_.n_wedges(), invalid_index), {}};
    if (n_charts == 0) return found;
    const LocalFunctions of_charts(functions_.input(), functions_.frame(), charts_, n_charts, threads_);
    found.functions.resize(n_charts * numbers_.n);
    for_each_range(n_charts, threads_, [&](std::size_t begin, std::size_t end) {
      for (auto chart = static_cast<Index>(begin); chart < end; ++chart) {
        if (of_charts.any(chart)) find_functions(of_charts, chart, &found.functions[chart * numbers_.n]);
      }
    });
    for (Index w = 0; w < charts_.size(); ++w) {
      const Index become = functions_.wedge_map()[w];
      if (become != invalid_index && charts_[w] != invalid_index) found.of_wedges[become] = charts_[w];
    }
    return found;
  }

 private:
  /// Those with `least_points`.
  void find_charts() {
    const std::vector<Index> firsts = first_equal_wedges(functions_.input(), numbers_.values, numbers_.n_components);
    charts_ = charts_of(functions_.input(), firsts);
    std::vector<std::size_t> n_points(charts_.size());
    for (Index w = 0; w < charts_.size(); ++w) n_points[charts_[w]] += firsts[w] == w ? 1 : 0;
    for (Index& chart : charts_) {
      if (n_points[chart] < least_points) chart = invalid_index;
    }
  }

  /// Numbers charts from 0 on. \return how many there are
  Index renumber() {
    std::vector<Index> numbers(charts_.size(), invalid_index);
    Index n = 0;
    for (Index& chart : charts_) {
      if (chart == invalid_index) continue;
      if (numbers[chart] == invalid_index) numbers[chart] = n++;
      chart = numbers[chart];
    }
    return n;
  }

  /// Most charts are not linear, and a few of their points tell: if a function was too far from none of these, the best
  /// one for them would leave no more than that. A chart that is left is looked at as a whole.
  void drop_bent_charts() {
    constexpr std::size_t n_sampled = 64;  // about so many wedges of a chart
    const Index n_charts = renumber();
    std::vector<std::size_t> n_points(n_charts);
    for (const Index chart : charts_) {
      if (chart != invalid_index) ++n_points[chart];
    }
    const std::vector<Index> vertices = vertices_of_wedges(functions_.input());
    const auto vertex_of = [&](Index w) { return vertices.empty() ? w : vertices[w]; };
    std::vector<std::vector<Index>> samples(n_charts);
    std::vector<std::size_t> places(n_charts);
    for (Index w = 0; w < charts_.size(); ++w) {
      const Index chart = charts_[w];
      const bool is_used = chart != invalid_index && vertex_of(w) != invalid_index;
      if (is_used && places[chart]++ % (n_points[chart] / n_sampled + 1) == 0) samples[chart].push_back(w);
    }
    std::vector<std::uint8_t> bent(n_charts);
    for (Index chart = 0; chart < n_charts; ++chart) {
      Eigen::MatrixX4d points(static_cast<Eigen::Index>(samples[chart].size()), 4);
      for (Eigen::Index k = 0; k < points.rows(); ++k) {
        const Index vertex = vertex_of(samples[chart][static_cast<std::size_t>(k)]);
        points.row(k) << functions_.frame().to_frame(functions_.input().positions[vertex]).transpose(), 1;
      }
      bent[chart] = is_bent(samples[chart], points) ? 1 : 0;
    }
    for (Index& chart : charts_) {
      if (chart != invalid_index && bent[chart] != 0) chart = invalid_index;
    }
  }

  /// Whether no number is linear, or not each if all need to be. Constants don't count. \param points where the wedges
  /// of the sample are, and
  /// 1
  bool is_bent(std::span<const Index> sample, const Eigen::MatrixX4d& points) const {
    const auto n = static_cast<Eigen::Index>(sample.size());
    std::vector<Spread> spreads(numbers_.n);
    Eigen::MatrixXd numbers(n, static_cast<Eigen::Index>(numbers_.n));
    for (Eigen::Index k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < numbers_.n; ++i) {
        const double number = numbers_.number(sample[static_cast<std::size_t>(k)], i);
        numbers(k, static_cast<Eigen::Index>(i)) = number;
        spreads[i].add(number);
      }
    }
    const Eigen::MatrixXd left = points * points.colPivHouseholderQr().solve(numbers) - numbers;
    bool is_any_linear = false;
    for (std::size_t i = 0; i < numbers_.n; ++i) {
      const double most = 2 * spreads[i].most();  // with a margin for rounding
      const bool is_near =
          !(left.col(static_cast<Eigen::Index>(i)).squaredNorm() > static_cast<double>(n) * most * most);
      if (numbers_.need_all && !is_near) return true;
      is_any_linear |= is_near && !spreads[i].is_constant();  // local functions of constants are constant, too
    }
    return !is_any_linear;
  }

  /// \param found n functions
  void find_functions(const LocalFunctions& charts, Index chart, LocalFunction* found) const {
    const std::vector<LocalFunction> functions = charts.around(chart, numbers_.n, numbers_.number);
    bool is_each_linear = true;
    for (std::size_t i = 0; i < numbers_.n; ++i) {
      Spread spread;
      charts.for_each_corner(chart, [&](Index w, const Vec3&) { spread.add(numbers_.number(w, i)); });
      bool is_linear = functions[i].is_linear;
      charts.for_each_corner(chart, [&](Index w, const Vec3& position) {
        is_linear = is_linear && std::abs(functions[i].at(position) - numbers_.number(w, i)) <= spread.most();
      });
      found[i] = functions[i];
      found[i].holds = is_linear;
      is_each_linear = is_each_linear && is_linear;
    }
    if (!numbers_.need_all || is_each_linear) return;
    for (std::size_t i = 0; i < numbers_.n; ++i) found[i].holds = false;
  }

  const LocalFunctions& functions_;
  const AttributeNumbers& numbers_;
  unsigned threads_;
  std::vector<Index> charts_;  ///< of each wedge of the input; invalid_index: of no meaning
};

}  // namespace

LinearCharts find_linear_charts(const LocalFunctions& functions, const AttributeNumbers& numbers, unsigned threads) {
  return ChartFinder(functions, numbers, threads).find();
}

}  // namespace whittle::detail
