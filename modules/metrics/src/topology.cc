// One loop over the edges joins connected items: vertices into components, corners into fans, and boundary edges into
// curves. The corners of two faces at an end of their common edge are in one fan.
#include "whittle/metrics/topology.hh"

#include <algorithm>
#include <vector>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/edge_table.hh"

namespace whittle::metrics {

namespace {

using detail::EdgeTable;
using detail::face_of;
using Sets = detail::DisjointSets<std::size_t>;

/// The number of the corner that a side has at a vertex.
Index corner_at(const IndexedMesh& mesh, Index side, Index vertex) {
  return detail::start_of(side, mesh.faces) == vertex ? side : detail::next_in_face(side);
}

bool is_misoriented(const IndexedMesh& mesh, const EdgeTable& edges, std::size_t e) {
  return edges.sides(e).size() == 2 && !edges.is_regular(e, mesh.faces);
}

/// Each face has two nodes, one for each orientation. An edge joins the orientations of its two faces that agree. If
/// both orientations of a face end in one set, the surface is not orientable.
bool is_orientable(const IndexedMesh& mesh, const EdgeTable& edges) {
  const std::size_t n = mesh.faces.size();
  Sets ways(2 * n);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto sides = edges.sides(e);
    if (sides.size() != 2) continue;
    const std::size_t first = face_of(sides[0]);
    const std::size_t second = face_of(sides[1]);
    const bool turned = is_misoriented(mesh, edges, e);
    ways.join(first, second + (turned ? n : 0));
    ways.join(first + n, second + (turned ? 0 : n));
  }
  for (std::size_t f = 0; f < n; ++f) {
    if (ways.find(f) == ways.find(f + n)) return false;
  }
  return true;
}

/// All boundary edges in a fan are in one curve, that of the first of them. \param fans the corners, joined
std::size_t count_boundary_loops(const IndexedMesh& mesh, const EdgeTable& edges, Sets& fans) {
  std::vector<std::size_t> first_in_fan(3 * mesh.faces.size(), edges.size());
  Sets curves(edges.size());
  std::size_t loops = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides(e).size() != 1) continue;
    ++loops;
    const Index side = edges.sides(e)[0];
    for (const Index corner : {side, detail::next_in_face(side)}) {
      std::size_t& first = first_in_fan[fans.find(corner)];
      if (first == edges.size()) {
        first = e;
      } else if (curves.join(first, e)) {
        --loops;
      }
    }
  }
  return loops;
}

}  // namespace

Topology topology(const IndexedMesh& mesh) {
  check_corners(mesh.positions.size(), mesh.faces);
  const EdgeTable edges(mesh.faces, mesh.positions.size());
  Topology result;
  result.edges = edges.size();

  std::vector<std::size_t> n_fans(mesh.positions.size(),
                                  0);  // first the corners of a vertex, then minus one for each join
  for (const Triangle& face : mesh.faces) {
    if (!has_three_corners(face)) {
      ++result.collapsed_faces;
    } else {
      ++result.faces;
      for (const Index v : face) ++n_fans[v];
    }
  }
  for (const std::size_t corners : n_fans) result.vertices += corners > 0 ? 1 : 0;

  Sets parts(mesh.positions.size()), fans(3 * mesh.faces.size());
  result.components = result.vertices;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [low, high] = edges[e];
    const auto sides = edges.sides(e);
    if (parts.join(low, high)) --result.components;
    for (std::size_t i = 1; i < sides.size(); ++i) {
      for (const Index v : {low, high}) {
        if (fans.join(corner_at(mesh, sides[0], v), corner_at(mesh, sides[i], v))) --n_fans[v];
      }
    }
    if (sides.size() == 1) ++result.boundary_edges;
    if (sides.size() > 2) ++result.nonmanifold_edges;
    if (is_misoriented(mesh, edges, e)) ++result.misoriented_edges;
  }
  for (const std::size_t n : n_fans) result.nonmanifold_vertices += n > 1 ? 1 : 0;
  if (result.boundary_edges > 0) result.boundary_loops = count_boundary_loops(mesh, edges, fans);

  result.euler = static_cast<long>(result.vertices) - static_cast<long>(result.edges) + static_cast<long>(result.faces);
  result.manifold = result.nonmanifold_edges == 0 && result.nonmanifold_vertices == 0 && result.collapsed_faces == 0;
  result.closed = result.faces > 0 && result.boundary_edges == 0;
  result.oriented = result.misoriented_edges == 0;
  result.orientable = result.oriented || is_orientable(mesh, edges);
  if (result.manifold && result.closed && result.orientable) {
    result.genus = static_cast<long>(result.components) - result.euler / 2;
  }
  return result;
}

}  // namespace whittle::metrics
