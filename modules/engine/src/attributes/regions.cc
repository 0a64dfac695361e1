#include "attributes/regions.hh"

#include <algorithm>

#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

Index wedge_at(const IndexedMesh& mesh, Index side, Index vertex) {
  const Index f = detail::face_of(side);
  const Triangle& face = mesh.faces[f];
  return mesh.wedge(f, static_cast<std::size_t>(std::find(face.begin(), face.end(), vertex) - face.begin()));
}

}  // namespace

std::vector<Index> surface_regions(const IndexedMesh& mesh, Break at) {
  const std::vector<VertexPair> seams = seam_edges(mesh);
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  detail::DisjointSets<Index> sets(mesh.faces.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> sides = edges.sides(e);
    if (sides.size() != 2 || std::binary_search(seams.begin(), seams.end(), edges[e])) continue;
    const auto is_continuous_at = [&](Index v) { return wedge_at(mesh, sides[0], v) == wedge_at(mesh, sides[1], v); };
    if (at == Break::any_wedge && !(is_continuous_at(edges[e].a) && is_continuous_at(edges[e].b))) continue;
    sets.join(detail::face_of(sides[0]), detail::face_of(sides[1]));
  }
  std::vector<Index> regions(mesh.faces.size());
  for (Index f = 0; f < regions.size(); ++f) regions[f] = sets.find(f);
  return regions;
}

}  // namespace whittle
