#include "whittle/core/geometry/proof/border_edges.hh"

#include <algorithm>

#include "whittle/core/detail/edge_table.hh"

namespace whittle {

BorderEdges border_edges_of(const IndexedMesh& mesh) {
  using detail::face_of, detail::next_in_face, detail::start_of;
  BorderEdges border;
  border.mesh.positions = mesh.positions;
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  std::vector<Index> sides;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides(e).size() == 1) sides.push_back(edges.sides(e)[0]);
  }
  std::sort(sides.begin(), sides.end());
  for (const Index side : sides) {
    const Index to = start_of(next_in_face(side), mesh.faces);
    border.mesh.faces.push_back({start_of(side, mesh.faces), to, to});
    border.faces.push_back(face_of(side));
  }
  return border;
}

}  // namespace whittle
