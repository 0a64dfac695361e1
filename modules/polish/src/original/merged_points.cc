#include "original/merged_points.hh"

#include <cmath>

#include "whittle/core/detail/compiler.hh"

namespace whittle::polishing {
namespace {

/// Distance of prefetching, in items: the time of a miss, some hundred nanoseconds.
constexpr std::ptrdiff_t ahead = 12;

template <class T>
const T* end_of(std::span<const T> items) {
  return items.data() + items.size();
}

}  // namespace

MergedPoints::MergedPoints(const Origins& origins, const Surface& mesh, Index end)
    : origins_(origins),
      finder_(mesh),
      vertices_end_(end_of(origins.of(end - 1))),
      corners_end_(end_of(origins.corners_of(end - 1))) {}

void MergedPoints::find(Index v) {
  const OriginalSurface& original = origins_.original();
  points_.clear();
  weights_.clear();
  for (const Index& origin : origins_.of(v)) {
    prefetch_after(&origin);
    add(original.positions()[origin], original.normal(origin), 0.25 * original.area(origin));
  }
  for (const Corner& corner : origins_.corners_of(v)) {
    prefetch_after(&corner);
    add_points_of_face(corner);
  }
  closest_points_.resize(points_.size());
  finder_.find(v, points_, closest_points_);
}

void MergedPoints::add(const Vec3& position, const Eigen::Vector3f& normal, double weight) {
  points_.push_back({position, normal});
  weights_.push_back(weight);
}

void MergedPoints::add_points_of_face(const Corner& corner) {
  const Triangle& face = origins_.original().faces()[corner.face];
  const std::span<const Vec3> positions = origins_.original().positions();
  const Eigen::Vector3f normal = area_normal(positions, face).cast<float>();
  const double area = 0.5F * std::sqrt(length_sq(normal));
  const double weight = 0.75 * area / static_cast<double>(origins_.points_per_face());
  const Vec3 sum = positions[face[0]] + positions[face[1]] + positions[face[2]];
  if (corner.slot == 0) add(sum / 3, normal, weight);
  if (origins_.points_per_face() > 1) add((sum + 3 * positions[face[corner.slot]]) / 6, normal, weight);
}

void MergedPoints::prefetch_after(const Index* vertex) const {
  if (vertices_end_ - vertex > ahead) origins_.original().prefetch(vertex[ahead]);
}

void MergedPoints::prefetch_after(const Corner* corner) const {
  const OriginalSurface& original = origins_.original();
  if (corners_end_ - corner > 2 * ahead) prefetch_line(&original.faces()[corner[2 * ahead].face]);
  if (corners_end_ - corner <= ahead) return;
  for (const Index v : original.faces()[corner[ahead].face]) prefetch_line(&original.positions()[v]);
}

}  // namespace whittle::polishing
