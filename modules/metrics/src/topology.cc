// One pass over the edges joins what hangs together: vertices into components, corners into fans (the corners two faces
// have at a common edge belong to one fan), the ends of boundary edges into curves, faces into oriented patches.
#include "whittle/metrics/topology.hh"

#include <algorithm>
#include <vector>

#include "checks.hh"
#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/edge_table.hh"

namespace whittle::metrics {

namespace {

using detail::EdgeTable;
using detail::face_of;
using Sets = DisjointSets<std::size_t>;

/// The number of the corner that a side has at a vertex.
Index corner_at(const IndexedMesh& mesh, Index side, Index vertex) {
  return detail::start_of(side, mesh.faces) == vertex ? side : detail::next_in_face(side);
}

bool is_misoriented(const IndexedMesh& mesh, const EdgeTable& edges, std::size_t e) {
  return edges.sides(e).size() == 2 && !edges.is_regular(e, mesh.faces);
}

/// Two nodes a face, one for each way to turn it; an edge joins the ways that go together. A face both ways of which
/// are in one set can't be turned right.
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

/// `fans`: the corners, joined. Of the boundary edges in a fan all are in the curve of the first one met.
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
  check_indices(mesh);
  const EdgeTable edges(mesh.faces, mesh.positions.size());
  Topology result;
  result.edges = edges.size();

  std::vector<std::size_t> n_fans(mesh.positions.size(), 0);  // first the corners of a vertex, less one for each join
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
