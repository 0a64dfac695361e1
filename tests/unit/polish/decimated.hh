#pragma once

#include "whittle/engine/decimate.hh"
#include "whittle/polish/polish.hh"

namespace whittle::test {

/// The mesh, decimated to `ratio` of its faces by memoryless quadrics, with the vertex map that polish needs.
inline Decimation decimated(const IndexedMesh& mesh, double ratio, DecimateOptions options = {}) {
  options.cost = Cost::memoryless;
  const double n_faces = ratio * static_cast<double>(mesh.faces.size());
  return decimate(mesh, DecimateTarget::faces(static_cast<std::uint64_t>(n_faces)), options);
}

inline IndexedMesh polished(const IndexedMesh& original, const Decimation& d, const PolishOptions& options = {}) {
  IndexedMesh mesh = d.mesh;
  polish(original, d.vertex_map, mesh, options);
  return mesh;
}

}  // namespace whittle::test
