#pragma once

#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::polishing {

/// A surface, and for each of its vertices the vertex of the simplified mesh, or `invalid_index`.
struct SimplifiedSurface {
  std::span<const Triangle> faces;
  std::span<const Vec3> positions;
  std::span<const Index> vertex_map;
};

}  // namespace whittle::polishing
