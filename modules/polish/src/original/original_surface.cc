#include "original/original_surface.hh"

#include <algorithm>
#include <cmath>

#include "whittle/core/detail/item_groups.hh"

namespace whittle::polishing {

OriginalSurface::OriginalSurface(const IndexedMesh& mesh, const detail::Workers& workers)
    : frame_(Frame::of_points(mesh.positions)),
      faces_(mesh.faces),
      positions_(mesh.positions.size()),
      normals_and_areas_(mesh.positions.size()) {
  for_each_range(positions_.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) positions_[v] = frame_.to_frame(mesh.positions[v]);
  });
  measure(workers);
  workers.update(0);
  faces_at_vertex_ = {positions_.size(), [this](const auto& add) {
                        for (Index f = 0; f < faces_.size(); ++f) {
                          for (const Index v : faces_[f]) add(v, f);
                        }
                      }};
}

void OriginalSurface::measure(const detail::Workers& workers) {
  constexpr std::size_t n_ahead = 12;                 // the time of a miss, some hundred nanoseconds
  constexpr Index check_mask = (Index{1} << 16) - 1;  // some milliseconds from check to check
  const auto measure_around = [&](Index begin, Index end, const auto& for_each_face) {
    workers.update(0);
    std::fill(normals_and_areas_.begin() + begin, normals_and_areas_.begin() + end, Eigen::Vector4f::Zero());
    for_each_face([&](Index f) {
      if ((f & check_mask) == 0) workers.update(0);
      if (f + n_ahead < faces_.size()) {
        for (const Index v : faces_[f + n_ahead]) prefetch(v);
      }
      const Eigen::Vector3f normal = area_normal(positions_, faces_[f]).cast<float>();
      const float area = 0.5F * std::sqrt(length_sq(normal));
      const Eigen::Vector4f sum(normal.x(), normal.y(), normal.z(), area / 3);
      for (const Index v : faces_[f]) {
        if (v >= begin && v < end) normals_and_areas_[v] += sum;
      }
    });
  };
  detail::for_each_vertex_range(faces_, positions_.size(), workers.threads, measure_around);
}

}  // namespace whittle::polishing
