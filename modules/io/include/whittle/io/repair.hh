#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// Counts of each kind of repair.
struct Repairs {
  std::size_t welded_vertices = 0;        ///< Vertices joined to an exact duplicate.
  std::size_t triangulated_polygons = 0;  ///< Faces with more than three corners.
  std::size_t degenerate_faces = 0;       ///< Faces dropped because fewer than three corners are different vertices.
  std::size_t duplicate_faces = 0;        ///< Faces dropped because they equal an earlier one.
  std::size_t isolated_vertices = 0;      ///< Vertices dropped because no face has them.

  /// Name and count of each kind, in this order. The names are the keys of `repairs` in JSON reports.
  std::array<std::pair<std::string_view, std::size_t>, 5> entries() const;
  bool any() const;
  Repairs& operator+=(const Repairs& more);
};

/// "welded 2100 vertices, dropped 108 degenerate faces, 2 isolated vertices". Empty if nothing was repaired.
std::string to_string(const Repairs& repairs);

/// Does all repairs: drops degenerate and duplicate faces, welds if `weld`, drops faces that welding made degenerate or
/// duplicate, and drops isolated vertices. Welded vertices don't count as isolated.
///
/// A sheet that exists twice with separate vertices would be welded to its copy along the border. If that would happen,
/// copies are dropped before welding: faces with the positions of an earlier face in the same cyclic order.
///
/// Corners keep their attributes: if welded vertices have different attributes, each becomes a wedge (`IndexedMesh`).
/// Wedges of a vertex with equal attributes are joined, and unused wedges dropped (`join_equal_wedges`).
/// \pre positions are finite, every corner is below V, attribute arrays are empty or full.
/// \param joined_to as for `weld_borders`.
/// \param threads largest number of threads; 0 = all cores. The result is the same for any number, here and below.
Repairs repair(IndexedMesh& mesh, bool weld = true, std::vector<Index>* joined_to = nullptr, unsigned threads = 0);

/// For each vertex before the repair, its vertex in the repaired mesh; `invalid_index` if it was dropped.
/// \param n_before number of vertices before
/// \param joined_to from `repair`
/// \pre the mesh's origins are numbers of vertices before the repair, or empty: none was dropped
std::vector<Index> vertex_map_of(const IndexedMesh& mesh, std::size_t n_before, const std::vector<Index>& joined_to);

/// Joins vertices with exactly equal positions (0.0 equals −0.0), if they lie on open borders (edges with one face) or
/// at the ends of an edge without length. The lowest numbered vertex stays, with its origin. Vertices joined to it
/// become isolated; different attributes become its wedges. Other coincident vertices stay apart: two closed parts
/// touch there.
///
/// No edge gets a third face. If joining all vertices would give one, the edge is in doubt. Then vertices at its ends
/// are only joined if their faces are connected across other edges. Faces that are still open at the edge are joined
/// pair by pair, in the order of faces, as long as no edge gets a third face. So a closed soup becomes closed, and
/// parts that touch along an edge stay apart. O(V + F) if no edge is in doubt; O(n log n) expected in the n corners at
/// doubtful edges.
///
/// If edges are in doubt, faces are dropped: with two corners at one position, or with the same three positions in the
/// same cyclic order as an earlier face. Otherwise no face is dropped.
/// \param joined_to if given, gets V numbers: for each vertex the vertex that it was joined to, or itself; empty if no
///        vertex was joined
/// \return counts of welded vertices, degenerate and duplicate faces.
Repairs weld_borders(IndexedMesh& mesh, std::vector<Index>* joined_to = nullptr, unsigned threads = 0);

/// Drops faces with two corners that are the same vertex. A face without area that has three different vertices (in a
/// line, or at one position but not welded) stays: dropping it would open the surface. \return the number dropped.
std::size_t drop_degenerate_faces(IndexedMesh& mesh);

/// Drops each face with the same vertices in the same cyclic order as an earlier face. Coincident faces with opposite
/// normals are no duplicates: both stay. O(V + F) if few faces are the same.
/// \return the number dropped.
std::size_t drop_duplicate_faces(IndexedMesh& mesh, unsigned threads = 0);

}  // namespace whittle::io
