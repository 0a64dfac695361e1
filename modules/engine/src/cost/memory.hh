#pragma once

#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "cost/attributes/surface_attributes.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/memoryless_term.hh"

namespace whittle {

/// What costs know of a surface that can't be told from it: what it was like at the start, and what vertices remember.
struct Memory {
  struct Remembered {
    Index vertex;  ///< by number in the input of the pass that gets the memory
    Quadric quadric;
  };

  MeanFaceArea face_area;
  std::vector<Remembered> quadrics;  ///< by vertex, ascending
  std::vector<Remembered> seams{};   ///< likewise, of vertices that remember nothing but planes of seams and rims
  SurfaceAttributes attributes{};    ///< none where costs don't look at attributes, or haven't seen them yet
};

/// For vertices that have moved.
inline void move_origins(Memory& memory, std::span<const Vec3> before, std::span<const Vec3> after) {
  for (std::vector<Memory::Remembered>* const all : {&memory.quadrics, &memory.seams}) {
    for (auto& [v, quadric] : *all) {
      const Vec3 way = after[v] - before[v];
      if (!way.isZero(0)) quadric = quadric.about(way);
    }
  }
  for (Index w = 0; w < memory.attributes.vertex_of.size(); ++w) {
    const Index v = memory.attributes.vertex_of[w];
    const Vec3 way = after[v] - before[v];
    if (!way.isZero(0)) memory.attributes.wedges.move_origin(w, way);
  }
}

/// Calls `use(vertex of the complex, quadric)` for each.
template <class Use>
void for_each_remembered(std::span<const Memory::Remembered> all, const TriangleComplex& complex, const Use& use) {
  if (all.empty()) return;
  const std::vector<Index> vertices = complex.vertices_by_origin();
  for (const auto& [vertex, quadric] : all) use(vertices[vertex], quadric);
}

}  // namespace whittle
