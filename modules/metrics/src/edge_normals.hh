#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// The unit normals of both faces at an edge. Where both faces run along it in the same direction, the second normal is
/// reversed. Nothing unless the edge has exactly two faces and both have a normal to be trusted.
std::optional<std::array<Vec3, 2>> normals_at(const IndexedMesh& mesh, const detail::EdgeTable& edges,
                                              std::size_t edge);

}  // namespace whittle::metrics
