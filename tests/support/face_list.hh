#pragma once

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>
#include <whittle/core/indexed_mesh.hh>

// Queries on a plain list of triangles, by definition: each counts anew from the list.

namespace whittle::test {

/// Lower vertex first.
using Edge = std::pair<Index, Index>;

inline Edge edge(Index a, Index b) { return std::minmax(a, b); }

inline bool has(const Triangle& face, Index v) { return face[0] == v || face[1] == v || face[2] == v; }

/// \pre the face has that corner
inline std::size_t corner_of(const Triangle& face, Index v) { return face[0] == v ? 0 : face[1] == v ? 1 : 2; }

std::map<Edge, int> count_edge_faces(std::span<const Triangle> faces);

/// The link of a vertex, with the cone vertex `invalid_index` over irregular edges and singular vertices.
struct Link {
  std::set<Index> vertices;
  std::multiset<Edge> edges;
  std::set<Index> irregular;  ///< other ends of irregular edges
  bool is_singular = false;   ///< neither one closed fan nor one open fan
};

/// \param faces those at v; others are ignored
Link link_of(Index v, std::span<const Triangle> faces);

/// The number of connected components of the link's edges.
int n_pieces(const Link& link);

}  // namespace whittle::test
