#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Splits polygons into triangles without new vertices. One object serves many polygons and reuses its memory.
///
/// A quad is split so that both triangles face the same way. If both diagonals do that, or neither, the shorter one is
/// taken. A larger polygon that is strictly convex becomes a fan; with more than 16 corners it is halved again and
/// again, so that no corner gets many triangles. Any other polygon is clipped ear by ear, in the plane of its vector
/// area (Newell); this is right for simple, nearly flat polygons. A polygon that crosses itself still gives n − 2
/// triangles.
class PolygonTriangulator {
 public:
  /// Writes n − 2 triangles to `out`. Their corners are places in the polygon, from 0. \param polygon vertex numbers
  /// \pre n ≥ 3, and `out` has n − 2 elements.
  void triangulate(std::span<const Index> polygon, const std::vector<Vec3>& positions, std::span<Triangle> out);

 private:
  using Point = std::array<double, 2>;

  void split_quad(std::span<const Index> quad, const std::vector<Vec3>& positions, std::span<Triangle> out);
  void project(std::span<const Index> polygon, const std::vector<Vec3>& positions);
  bool is_strictly_convex() const;
  void clip_ears(std::span<Triangle> out);
  bool is_ear(std::uint32_t corner);
  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  void build_grid();

  std::vector<Point> points_;        // The corners in the polygon's plane, counter-clockwise, in about [-1, 1].
  std::vector<std::uint32_t> next_;  // The polygon that is left, as a ring of corners.
  std::vector<std::uint32_t> previous_;
  // Reflex corners by grid cell, so that an ear is tested against near ones only. Clipping ears only makes corners
  // convex: cells never gain a corner. `is_reflex_` tells which corners are still reflex.
  std::vector<char> is_reflex_;
  std::vector<std::uint32_t> cell_begin_;
  std::vector<std::uint32_t> cell_corners_;
  std::uint32_t cells_ = 1;  // Along each axis.
  std::uint64_t tests_left_ = 0;
};

}  // namespace whittle::io
