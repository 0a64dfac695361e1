#include "surface/backward_offsets.hh"

#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

#include "surface/surface_walk.hh"

namespace whittle::polishing {
namespace {

/// For each vertex of the mesh the nearest of the original's vertices that were merged into it, or `invalid_index`.
std::vector<Index> nearest_origins(const SimplifiedSurface& original, std::span<const Vec3> positions,
                                   const detail::Workers& workers) {
  // Distance and number in one word: the least is the nearest, of equally near ones that of the lowest number.
  constexpr auto none = ~std::uint64_t{0};
  std::vector<std::uint64_t> nearest(positions.size(), none);
  const std::span<const Index> vertex_map = original.vertex_map;
  for_each_range(vertex_map.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const Index to = vertex_map[v];
      if (to == invalid_index) continue;
      const auto distance = static_cast<float>((original.positions[v] - positions[to]).norm());
      const std::uint64_t word = std::uint64_t{std::bit_cast<std::uint32_t>(distance)} << 32 | v;
      std::atomic_ref<std::uint64_t> least(nearest[to]);
      std::uint64_t now = least.load(std::memory_order_relaxed);
      while (word < now && !least.compare_exchange_weak(now, word, std::memory_order_relaxed)) {
      }
    }
  });
  std::vector<Index> origins(nearest.size());
  for (std::size_t v = 0; v < origins.size(); ++v) {
    origins[v] = nearest[v] == none ? invalid_index : static_cast<Index>(nearest[v]);
  }
  return origins;
}

/// Whether a point may be further than `near` from the surface around a vertex: if it is so far from the vertex'
/// tangent plane, or so far from the vertex that the plane tells nothing, or if there is no such plane.
bool may_be_far(const SurfaceSamples& samples, Index origin, const Vec3& point, double near) {
  constexpr double least_flatness = 0.98;
  const Vec3 offset = point - samples.positions()[origin];
  const double square = offset.squaredNorm();
  if (!(square > near * near)) return false;
  const double area = samples.area(origin);
  const Vec3 normal = samples.normal(origin).cast<double>();
  const double normal_sq = normal.squaredNorm();
  if (!(normal_sq > least_flatness * least_flatness * 36 * area * area)) return true;
  const double height = normal.dot(offset);
  return !(height * height <= near * near * normal_sq) || square > (near + std::sqrt(area)) * (near + std::sqrt(area));
}

/// From the nearest point of the original.
Vec3 offset_from(const Surface& original, const Vec3& point, Index start) {
  const NearestPoint nearest = walk_to_nearest(original, point, start);
  if (nearest.corner == nullptr) return Vec3::Zero();
  const Triangle& face = original.faces[nearest.corner->face];
  const Index slot = nearest.corner->slot;
  const auto corner = [&](Index i) -> const Vec3& { return original.positions[corner_after(face, slot, i)]; };
  const Vec3 foot = (1 - nearest.next - nearest.last) * corner(0) + nearest.next * corner(1) + nearest.last * corner(2);
  return point - foot;
}

}  // namespace

BackwardOffsets::BackwardOffsets(const SimplifiedSurface& original, const SurfaceSamples& samples,
                                 std::span<const Vec3> positions, const detail::Workers& workers)
    : original_(original), samples_(samples), origins_(nearest_origins(original, positions, workers)) {}

std::vector<Vec3> BackwardOffsets::at(std::span<const Vec3> positions, double near,
                                      const detail::Workers& workers) const {
  std::vector<std::uint8_t> is_far(origins_.size());
  for_each_range(origins_.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      is_far[v] = origins_[v] != invalid_index && may_be_far(samples_, origins_[v], positions[v], near);
    }
  });
  std::vector<std::uint8_t> is_wanted(original_.positions.size());
  for_each_range(is_wanted.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Index to = original_.vertex_map[v];
      is_wanted[v] = to != invalid_index && is_far[to] != 0;
    }
  });
  const VertexCorners corners = corners_by_vertex(original_.faces, is_wanted, workers);
  const Surface around{original_.faces, corners, original_.positions};
  std::vector<Vec3> offsets(origins_.size(), Vec3::Zero());
  for_each_range(origins_.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (is_far[v] != 0) offsets[v] = offset_from(around, positions[v], origins_[v]);
    }
  });
  return offsets;
}

}  // namespace whittle::polishing
