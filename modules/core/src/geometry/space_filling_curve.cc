#include "whittle/core/geometry/space_filling_curve.hh"

#include <algorithm>
#include <array>
#include <limits>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle {
namespace {

/// Spreads the low 10 bits of x to every third bit.
std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | (x << 16)) & 0x030000FF;
  x = (x | (x << 8)) & 0x0300F00F;
  x = (x | (x << 4)) & 0x030C30C3;
  return (x | (x << 2)) & 0x09249249;
}

/// Stable sort by cell, 10 bits a pass.
void radix_sort(std::vector<CurvePoint>& points) {
  std::vector<CurvePoint> sorted(points.size());
  for (const unsigned shift : {0U, 10U, 20U}) {
    std::array<std::size_t, 1025> starts{};
    for (const CurvePoint& p : points) ++starts[((p.cell >> shift) & 1023) + 1];
    for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
    for (const CurvePoint& p : points) sorted[starts[(p.cell >> shift) & 1023]++] = p;
    points.swap(sorted);
  }
}

}  // namespace

std::vector<CurvePoint> along_morton_curve(std::span<const Vec3> positions, const Frame& frame, unsigned threads) {
  if (positions.empty()) return {};
  const Box box = bounds_of(positions);  // rounding keeps the order, so its corners map to the frame's
  const Vec3 low = frame.to_frame(box.min());
  const double extent = (frame.to_frame(box.max()) - low).maxCoeff();
  constexpr double least = 1024 * std::numeric_limits<double>::min();  // below it the quotient is no number
  const double cells_per_unit = extent > least ? 1023.0 / extent : 0;
  std::vector<CurvePoint> points(positions.size());
  for_each_range(positions.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 cell = (frame.to_frame(positions[i]) - low) * cells_per_unit;
      const auto bits = [&](int axis) { return spread_bits(static_cast<std::uint32_t>(cell[axis])); };
      points[i] = {bits(0) | bits(1) << 1 | bits(2) << 2, static_cast<Index>(i)};
    }
  });
  radix_sort(points);
  return points;
}

std::vector<Index> morton_order(std::span<const Vec3> positions, const Frame& frame, unsigned threads) {
  const std::vector<CurvePoint> points = along_morton_curve(positions, frame, threads);
  std::vector<Index> order(points.size());
  std::transform(points.begin(), points.end(), order.begin(), [](const CurvePoint& p) { return p.number; });
  return order;
}

}  // namespace whittle
