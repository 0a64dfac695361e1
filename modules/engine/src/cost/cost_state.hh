#pragma once

#include <optional>
#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "cost/attributes/surface_attributes.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

/// A quadric about its vertex, in the frame.
struct VertexQuadric {
  Index vertex;  ///< of the surface that has the state
  Quadric quadric;
};

/// What costs know of a surface that can't be told from its faces. A stage leaves it, and the next one starts from it.
/// Vertices that are in no list have the planes of their faces and borders.
struct CostState {
  std::optional<MeanFaceArea> face_area{};  ///< at the start of the run; none: to be measured
  std::vector<VertexQuadric> quadrics{};    ///< all that these vertices know; ascending
  std::vector<VertexQuadric> seams{};       ///< planes of seams and folds, besides those of faces; ascending
  std::vector<VertexQuadric> faces{};       ///< in the place of sums over the vertices' faces and borders; ascending
  SurfaceAttributes attributes{};           ///< none where costs don't look at attributes, or haven't seen them yet

  /// For vertices that have moved.
  void move_origins(std::span<const Vec3> before, std::span<const Vec3> after);
};

/// Calls `use(vertex of the complex, quadric)` for each.
template <class Use>
void for_each_quadric(std::span<const VertexQuadric> all, const TriangleComplex& complex, const Use& use) {
  if (all.empty()) return;
  const std::vector<Index> vertices = complex.vertices_by_origin();
  for (const auto& [vertex, quadric] : all) use(vertices[vertex], quadric);
}

}  // namespace whittle
