#include "original/backward_offsets.hh"

#include <algorithm>
#include <cmath>

namespace whittle::polishing {

BackwardOffsets::BackwardOffsets(const Origins& origins, const Surface& mesh, double near,
                                 const detail::Workers& workers)
    : origins_(origins), mesh_(mesh), near_(near), nearest_(mesh.positions.size()) {
  for_each_range(nearest_.size(), workers, [this](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) nearest_[v] = origins_.nearest(v, mesh_.positions[v]);
  });
  offsets_ = offsets_at(
      mesh.positions, [&](Index v) { return may_be_far(v, mesh.positions[v], near); }, workers);
}

std::vector<Vec3> BackwardOffsets::after_moves(std::span<const Vec3> positions, double near,
                                               const detail::Workers& workers) const {
  const auto may_be = [&](Index v) {
    const double before = std::max(near_, offsets_[v].norm());
    return before + (positions[v] - mesh_.positions[v]).norm() > near && may_be_far(v, positions[v], near);
  };
  return offsets_at(positions, may_be, workers);
}

template <class MayBeFar>
std::vector<Vec3> BackwardOffsets::offsets_at(std::span<const Vec3> positions, const MayBeFar& may_be_far,
                                              const detail::Workers& workers) const {
  constexpr std::size_t length = 1024;
  std::vector<Vec3> offsets(positions.size(), Vec3::Zero());
  for_each_block((positions.size() + length - 1) / length, workers, [&](std::size_t block) {
    const std::size_t end = std::min(positions.size(), (block + 1) * length);
    for (auto v = static_cast<Index>(block * length); v < end; ++v) {
      if (nearest_[v] != invalid_index && may_be_far(v)) offsets[v] = offset(v, positions[v]);
    }
  });
  return offsets;
}

Vec3 BackwardOffsets::offset(Index v, const Vec3& position) const {
  const OriginalSurface& original = origins_.original();
  const SurfacePoint closest = original.nearest(position, nearest_[v]);
  return closest.face == invalid_index ? Vec3(Vec3::Zero()) : Vec3(position - original.position_of(closest));
}

/// Whether a position of a vertex may be further than `near` from the original. So it is if the tangent plane of the
/// nearest origin is that far, if the origin is too far for the plane to tell, or if there is no such plane.
bool BackwardOffsets::may_be_far(Index v, const Vec3& position, double near) const {
  constexpr double least_flatness = 0.98;
  const OriginalSurface& original = origins_.original();
  const Vec3 offset = position - original.positions()[nearest_[v]];
  const double square = offset.squaredNorm();
  if (!(square > near * near)) return false;
  const double area = original.area(nearest_[v]);
  const Vec3 normal = original.normal(nearest_[v]).cast<double>();
  const double normal_sq = normal.squaredNorm();
  if (!(normal_sq > least_flatness * least_flatness * 36 * area * area)) return true;
  const double height = normal.dot(offset);
  return !(height * height <= near * near * normal_sq) || square > (near + std::sqrt(area)) * (near + std::sqrt(area));
}

}  // namespace whittle::polishing
