#include "decimate/output.hh"

#include <utility>

#include "loop/contraction_log.hh"

namespace whittle {
Decimation geometry_of(const IndexedMesh& input, Remainder left, const Frame& frame) {
  Decimation out;
  IndexedMesh& mesh = out.mesh;
  mesh.positions = std::move(left.positions);
  mesh.origins = std::move(left.origins);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Index& v = mesh.origins[i];
    mesh.positions[i] = to_output(mesh.positions[i], input.positions[v], frame);
    if (!input.origins.empty()) v = input.origins[v];
  }
  mesh.faces = std::move(left.faces);
  out.face_origins = std::move(left.face_origins);
  out.vertex_map = std::move(left.vertex_map);
  out.feature_edges = std::move(left.lines.edges);
  out.quadrics = std::move(left.quadrics);
  return out;
}

}  // namespace whittle
