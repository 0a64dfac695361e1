#include "whittle/core/geometry/proof/border_edges.hh"

#include <algorithm>
#include <cstdint>

#include "whittle/core/detail/edge_table.hh"

namespace whittle {
namespace {

/// Faces with two vertices on borders.
std::vector<std::uint8_t> faces_at(const std::vector<std::uint8_t>& is_on_border, const std::vector<Triangle>& faces) {
  std::vector<std::uint8_t> is_chosen;
  is_chosen.reserve(faces.size());
  for (const auto& [a, b, c] : faces) {
    is_chosen.push_back(static_cast<std::uint8_t>(is_on_border[a] + is_on_border[b] + is_on_border[c] >= 2));
  }
  return is_chosen;
}

}  // namespace

BorderEdges border_edges_of(const IndexedMesh& mesh) {
  using detail::face_of, detail::next_in_face, detail::start_of;
  BorderEdges border;
  const std::vector<std::uint8_t> is_on_border = detail::border_vertices(mesh.faces, mesh.positions.size());
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size(), faces_at(is_on_border, mesh.faces));
  std::vector<Index> sides;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = edges[e];
    const bool has_all_sides = is_on_border[a] != 0 && is_on_border[b] != 0;
    if (has_all_sides && edges.sides(e).size() == 1) sides.push_back(edges.sides(e)[0]);
  }
  if (sides.empty()) return border;
  border.mesh.positions = mesh.positions;
  std::sort(sides.begin(), sides.end());
  for (const Index side : sides) {
    const Index to = start_of(next_in_face(side), mesh.faces);
    border.mesh.faces.push_back({start_of(side, mesh.faces), to, to});
    border.faces.push_back(face_of(side));
  }
  return border;
}

}  // namespace whittle
