#include "plan/charts.hh"

#include <algorithm>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/two_sided.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// Whether texture coordinates differ between the two faces of each inner edge, at one of its ends at least.
/// \pre the mesh has a table of wedges
bool has_chart_per_face(const IndexedMesh& mesh, const Attribute& texcoords) {
  const std::vector<Index> numbers = faces_without_backs(mesh);
  std::vector<Triangle> faces;
  faces.reserve(numbers.size());
  for (const Index f : numbers) faces.push_back(mesh.faces[f]);
  const detail::EdgeTable edges(faces, mesh.positions.size());
  const auto differ = [&](Index side, Index other) {
    const auto of_corner = [&](Index corner) { return texcoords.value(mesh.wedge(numbers[corner / 3], corner % 3)); };
    const auto a = of_corner(side);
    const auto b = of_corner(other);
    return !std::equal(a.begin(), a.end(), b.begin());
  };
  std::size_t n_inner = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_regular(e, faces)) continue;
    ++n_inner;
    const Index first = edges.sides(e)[0];
    const Index second = edges.sides(e)[1];
    // The sides run in opposite directions.
    if (!differ(first, detail::next_in_face(second)) && !differ(detail::next_in_face(first), second)) return false;
  }
  return n_inner > 0;
}

}  // namespace

bool has_chart_per_face(const IndexedMesh& mesh) {
  if (mesh.wedges.empty()) return false;
  return std::any_of(mesh.attributes.begin(), mesh.attributes.end(), [&](const Attribute& attribute) {
    return attribute.kind == AttributeKind::texcoord && has_chart_per_face(mesh, attribute);
  });
}

}  // namespace whittle
