#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::app {

/// An option of `simplify` that suits a mesh.
struct Suggestion {
  std::string option;
  std::string reason;
};

/// The kind of a mesh, and suitable options.
struct MeshKind {
  /// "closed" or "open"; "soup" where faces hardly hang together, "CAD" where most edges are flat, "tile" where the
  /// border lies on the bounding box, "parts" where there are several, "two-sided" where faces have backs: then the
  /// other words, the share and the suggestions describe the mesh without backs, as `simplify` sees it.
  std::vector<std::string> words;
  double flat_edges = 0;  ///< share of the edges of two faces that lie in one plane, [0, 1]
  std::vector<Suggestion> suggestions;
};

/// Whether many edges are flat, as in CAD. \pre the mesh has faces
bool is_mostly_flat(const IndexedMesh& mesh);

/// \param topology that of `mesh` \param is_gltf its file: then --weld and --threshold aren't taken
/// \pre the mesh has faces
MeshKind kind_of(const IndexedMesh& mesh, const metrics::Topology& topology, bool is_gltf, unsigned threads);

}  // namespace whittle::app
