#include <optional>
#include <utility>

#include "whittle/engine/decimate.hh"

namespace whittle {
IndexOnlyDecimation decimate_index_only(const IndexedMesh& mesh, const DecimateTarget& target,
                                        const DecimateOptions& options) {
  DecimateOptions at_ends = options;
  at_ends.quadric.placement = Placement::endpoint;
  std::optional<IndexedMesh> plain;  // the origins are to be numbers of `mesh`
  if (!mesh.origins.empty()) {
    plain = mesh;
    plain->origins.clear();
  }
  Decimation small = decimate(plain ? *plain : mesh, target, at_ends);
  const std::vector<Index>& kept = small.mesh.origins;
  IndexOnlyDecimation out;
  out.faces.reserve(small.mesh.faces.size());
  for (const auto& [a, b, c] : small.mesh.faces) out.faces.push_back({kept[a], kept[b], kept[c]});
  out.result = std::move(small.result);
  out.face_origins = std::move(small.face_origins);
  out.vertex_map = std::move(small.vertex_map);
  for (Index& v : out.vertex_map) {
    if (v != invalid_index) v = kept[v];
  }
  return out;
}

}  // namespace whittle
