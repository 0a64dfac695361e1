#pragma once

#include <array>
#include <span>

#include "complex/contraction_profile.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {

/// A position, as lanes load it.
struct alignas(32) LanePoint {
  LanePoint() = default;
  explicit LanePoint(const Vec3& p) : coordinates{p.x(), p.y(), p.z(), 0} {}
  operator Vec3() const { return {coordinates[0], coordinates[1], coordinates[2]}; }

  std::array<double, 4> coordinates{};
};

/// Sums over the faces at a vertex: what ranks and places pairs with it. The vertex is in all their planes, so about it
/// these have no slope and no constant.
struct alignas(32) StarPlanes {
  /// The quadric's matrix: xx, xy, xz, yy, yz, zz; then Σ n and Σ |n|, n a face's normal, as long as twice its area;
  /// and two zeros.
  std::array<double, 12> sums{};

  SymmetricMatrix matrix() const { return {sums[0], sums[1], sums[2], sums[3], sums[4], sums[5]}; }
  Vec3 normal() const { return {sums[6], sums[7], sums[8]}; }
  double length() const { return sums[9]; }
};

/// The sums for a star. They are made of four sums, each over every fourth face.
/// \param faces those with two equal corners count for nothing
StarPlanes planes_of_star(Index vertex, std::span<const LinkEdge> faces, std::span<const LanePoint> points,
                          const QuadricOptions& options);

}  // namespace whittle
