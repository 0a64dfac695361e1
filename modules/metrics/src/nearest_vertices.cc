#include "whittle/metrics/nearest_vertices.hh"

#include <algorithm>

#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "working_scale.hh"

namespace whittle::metrics {

std::vector<Index> nearest_vertices(const IndexedMesh& from, const IndexedMesh& to, unsigned threads,
                                    const ProgressCallback& progress) {
  const Box from_box = bounds_of(from), to_box = bounds_of(to);
  if (const double scale = working_scale({from_box, to_box}); scale != 1.0) {
    return nearest_vertices(scaled(from, scale), scaled(to, scale), threads, progress);
  }
  detail::ProgressMeter meter(progress);
  const detail::Workers workers(threads, &meter);
  meter.start("building the search tree", 0.3);
  const TriangleTree tree(to, center_of(to_box), &meter);
  meter.start("searching", 1);
  std::vector<Index> nearest(from.positions.size(), invalid_index);
  std::vector<std::uint8_t> has_face(from.positions.size());
  for (const Triangle& face : from.faces) {
    for (const Index v : face) has_face[v] = 1;
  }
  for_each_range(nearest.size(), workers, [&](std::size_t begin, std::size_t end) {
    Index hint = invalid_index;
    for (std::size_t v = begin; v < end; ++v) {
      if (has_face[v] == 0) continue;
      const Vec3& point = from.positions[v];
      hint = tree.nearest(point, hint).face;
      nearest[v] = *std::ranges::min_element(
          to.faces[hint], {}, [&](Index corner) { return (to.positions[corner] - point).squaredNorm(); });
    }
  });
  meter.finish();
  return nearest;
}

}  // namespace whittle::metrics
