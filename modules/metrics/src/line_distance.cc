// The mean is the trapezoidal rule on each segment: an inner sample represents one interval, an end half of one.
// Segments are taken in blocks by number, and the blocks are summed in order. So the result is the same for any number
// of threads.
//
// A segment goes into the hierarchy as a triangle with two equal corners, which counts as a segment.
#include "whittle/metrics/line_distance.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "noise.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

constexpr std::size_t segments_per_block = 64;
/// Spacing as fine as float coordinates. A segment has at most a million samples.
constexpr double min_spacing_rel = 1e-6;

IndexedMesh as_mesh(std::span<const Segment> lines) {
  if (lines.size() >= invalid_index / 2) throw std::invalid_argument("too many segments");
  IndexedMesh mesh;
  mesh.positions.reserve(2 * lines.size());
  mesh.faces.reserve(lines.size());
  for (const auto& [from, to] : lines) {
    const auto first = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(from);
    mesh.positions.push_back(to);
    mesh.faces.push_back({first, first + 1, first + 1});
  }
  return mesh;
}

struct LineSums {
  double length = 0.0;        ///< Of the segments.
  double distance = 0.0;      ///< Integral over them, model units squared.
  double mean_of_each = 0.0;  ///< Sum of the segments' means, in case none has a length.
  double max_sq = 0.0;

  void add(const LineSums& other) {
    length += other.length;
    distance += other.distance;
    mean_of_each += other.mean_of_each;
    max_sq = std::max(max_sq, other.max_sq);
  }
};

/// The points of some lines against the lines in a tree.
struct LineDirection {
  const TriangleTree& tree;
  double spacing;
  double noise_sq;

  void measure(const Segment& segment, Index& hint, LineSums& sums) const {
    const Vec3 from = segment.from - tree.origin(), along = segment.to - segment.from;
    const double length = along.norm();
    const std::size_t intervals = length > spacing ? static_cast<std::size_t>(std::ceil(length / spacing)) : 1;
    double sum = 0.0;
    for (std::size_t i = 0; i <= intervals; ++i) {
      const bool is_end = i == 0 || i == intervals;
      const double t = static_cast<double>(i) / static_cast<double>(intervals);
      const Vec3 point = i < intervals ? Vec3(from + t * along) : Vec3(segment.to - tree.origin());
      const ClosestPoint nearest = tree.nearest_local(point, hint);
      hint = nearest.face;
      const double distance_sq = nearest.distance_sq > noise_sq ? nearest.distance_sq : 0.0;
      sum += (is_end ? 0.5 : 1.0) * std::sqrt(distance_sq);
      sums.max_sq = std::max(sums.max_sq, distance_sq);
    }
    const double mean = sum / static_cast<double>(intervals);
    sums.length += length;
    sums.distance += mean * length;
    sums.mean_of_each += mean;
  }

  DirectedLineDistance measure(std::span<const Segment> lines, const detail::Workers& workers) const {
    std::vector<LineSums> blocks((lines.size() + segments_per_block - 1) / segments_per_block);
    for_each_block(blocks.size(), workers, [&](std::size_t block) {
      Index hint = invalid_index;
      const std::size_t begin = block * segments_per_block;
      for (const Segment& segment : lines.subspan(begin, std::min(segments_per_block, lines.size() - begin))) {
        measure(segment, hint, blocks[block]);
      }
    });
    LineSums total;
    for (const LineSums& block : blocks) total.add(block);
    const double mean =
        total.length > 0.0 ? total.distance / total.length : total.mean_of_each / static_cast<double>(lines.size());
    return {mean, std::sqrt(total.max_sq)};
  }
};

std::vector<Segment> scaled(std::span<const Segment> lines, double scale) {
  std::vector<Segment> result;
  result.reserve(lines.size());
  for (const auto& [from, to] : lines) result.push_back({from * scale, to * scale});
  return result;
}

LineDistance scaled(LineDistance distance, double scale) {
  for (double* length : {&distance.forward.mean, &distance.forward.max, &distance.backward.mean, &distance.backward.max,
                         &distance.mean, &distance.max}) {
    *length *= scale;
  }
  return distance;
}

}  // namespace

std::optional<LineDistance> line_distance(std::span<const Segment> reference, std::span<const Segment> test,
                                          const LineDistanceOptions& options) {
  if (!(options.spacing_rel >= min_spacing_rel && options.spacing_rel <= 1.0)) {
    throw std::invalid_argument("spacing is to be in [1e-6, 1] of the diagonal, not " +
                                std::to_string(options.spacing_rel));
  }
  if (reference.empty() || test.empty()) return std::nullopt;
  const IndexedMesh reference_mesh = as_mesh(reference), test_mesh = as_mesh(test);
  const Box reference_box = bounds_of(reference_mesh), test_box = bounds_of(test_mesh);
  if (const double scale = working_scale({reference_box, test_box}); scale != 1.0) {
    return scaled(*line_distance(scaled(reference, scale), scaled(test, scale), options), 1.0 / scale);
  }
  const double diagonal = std::max(diagonal_of(reference_box), diagonal_of(test_box));
  const double spacing = options.spacing_rel * diagonal, noise = noise_rel * diagonal;
  detail::ProgressMeter meter(options.progress);
  const detail::Workers workers(options.threads, &meter);
  meter.start("building the search trees", 0.2);
  const TriangleTree reference_tree(reference_mesh, center_of(reference_box), &meter);
  const TriangleTree test_tree(test_mesh, center_of(reference_box), &meter);
  meter.start("measuring lines", 1);

  LineDistance result;
  result.forward = LineDirection{test_tree, spacing, noise * noise}.measure(reference, workers);
  result.backward = LineDirection{reference_tree, spacing, noise * noise}.measure(test, workers);
  meter.finish();
  result.mean = 0.5 * (result.forward.mean + result.backward.mean);
  result.max = std::max(result.forward.max, result.backward.max);
  return result;
}

}  // namespace whittle::metrics
