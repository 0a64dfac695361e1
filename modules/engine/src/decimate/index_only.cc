#include <stdexcept>
#include <utility>

#include "whittle/engine/decimate.hh"

namespace whittle {
namespace {

/// For each vertex of a result under endpoint placement, the vertex of the input whose place it has. Of several at one
/// position it is the first.
std::vector<Index> vertices_kept(const IndexedMesh& input, const Decimation& small) {
  std::vector<Index> kept(small.mesh.positions.size(), invalid_index);
  for (Index v = 0; v < small.vertex_map.size(); ++v) {
    const Index merged = small.vertex_map[v];
    if (merged == invalid_index || kept[merged] != invalid_index) continue;
    if (small.mesh.positions[merged] == input.positions[v]) kept[merged] = v;
  }
  for (const Index v : kept) {
    if (v == invalid_index) throw std::logic_error("decimate_index_only: a vertex lies where no input vertex does");
  }
  return kept;
}

}  // namespace

IndexOnlyDecimation decimate_index_only(const IndexedMesh& mesh, const DecimateTarget& target,
                                        const DecimateOptions& options) {
  DecimateOptions at_ends = options;
  at_ends.quadric.placement = Placement::endpoint;
  Decimation small = decimate(mesh, target, at_ends);
  const std::vector<Index> kept = vertices_kept(mesh, small);
  IndexOnlyDecimation out;
  out.faces.reserve(small.mesh.faces.size());
  for (const auto& [a, b, c] : small.mesh.faces) out.faces.push_back({kept[a], kept[b], kept[c]});
  out.result = std::move(small.result);
  std::erase_if(out.result.warnings, [](const Warning& warning) {  // the caller still has all attributes
    return warning.kind == WarningKind::texcoords_dropped || warning.kind == WarningKind::groups_dropped;
  });
  out.face_origins = std::move(small.face_origins);
  out.vertex_map = std::move(small.vertex_map);
  for (Index& v : out.vertex_map) {
    if (v != invalid_index) v = kept[v];
  }
  return out;
}

}  // namespace whittle
