#include "commands/simplify/input_warnings.hh"

#include <algorithm>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/wedges.hh"

namespace whittle::app {
namespace {

std::vector<std::string> lost_in_openmesh(const SimplifyCommand& options, const Input& input) {
  std::vector<std::string> warnings;
  const auto add = [&](const char* what) {
    warnings.push_back(input.name + ": " + what + " are not carried by --engine openmesh");
  };
  if (!input.read.mesh.normals.empty() && options.simplify.decimate.normals != Normals::drop) add("vertex normals");
  if (!input.read.mesh.colors.empty()) add("vertex colours");
  return warnings;
}

/// Whether texture coordinates differ between the two faces of each inner edge, at one of its ends at least.
/// \pre the mesh has a table of wedges
bool has_chart_per_face(const IndexedMesh& mesh, const Attribute& texcoords) {
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  const auto differ = [&](Index side, Index other) {
    const auto of_corner = [&](Index corner) { return texcoords.value(mesh.wedge(corner / 3, corner % 3)); };
    const auto a = of_corner(side);
    const auto b = of_corner(other);
    return !std::equal(a.begin(), a.end(), b.begin());
  };
  std::size_t n_inner = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_regular(e, mesh.faces)) continue;
    ++n_inner;
    const Index first = edges.sides(e)[0];
    const Index second = edges.sides(e)[1];
    // The sides run in opposite directions.
    if (!differ(first, detail::next_in_face(second)) && !differ(detail::next_in_face(first), second)) return false;
  }
  return n_inner > 0;
}

bool has_chart_per_face(const IndexedMesh& mesh) {
  if (mesh.wedges.empty()) return false;
  return std::any_of(mesh.attributes.begin(), mesh.attributes.end(), [&](const Attribute& attribute) {
    return attribute.kind == AttributeKind::texcoord && has_chart_per_face(mesh, attribute);
  });
}

}  // namespace

std::vector<std::string> input_warnings(const SimplifyCommand& options, const Input& input) {
  std::vector<std::string> warnings;
  if (options.engine == Engine::openmesh) warnings = lost_in_openmesh(options, input);
  if (has_chart_per_face(input.read.mesh)) {
    warnings.push_back(input.name +
                       ": each triangle is a chart of its own on the texture, so each edge is a seam: neither texture "
                       "nor shape can be kept well; '--attributes position-only' drops the texture and keeps the "
                       "shape, and a texture baked anew in larger charts keeps both");
  }
  return warnings;
}

}  // namespace whittle::app
