#pragma once

#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
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
  std::vector<Remembered> seams{};   ///< likewise, of vertices that remember nothing but planes of seams
};

/// Calls `use(vertex of the complex, quadric)` for each.
template <class Use>
void for_each_remembered(std::span<const Memory::Remembered> all, const TriangleComplex& complex, const Use& use) {
  if (all.empty()) return;
  const std::vector<Index> vertices = complex.vertices_by_origin();
  for (const auto& [vertex, quadric] : all) use(vertices[vertex], quadric);
}

}  // namespace whittle
