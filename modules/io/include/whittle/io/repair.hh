#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::io {

/// How often each kind of repair was needed.
struct Repairs {
  std::size_t welded_vertices = 0;        ///< Vertices that became one with an exact duplicate.
  std::size_t triangulated_polygons = 0;  ///< Faces with more than three corners.
  std::size_t degenerate_faces = 0;       ///< Faces dropped because two of their corners coincide.
  std::size_t duplicate_faces = 0;        ///< Faces dropped because an earlier one has the same corners, same side up.
  std::size_t isolated_vertices = 0;      ///< Vertices dropped because no face uses them.

  /// Name and count of each kind, in this order; the names are the keys of `repairs` in the JSON report.
  std::array<std::pair<std::string_view, std::size_t>, 5> entries() const;
  bool any() const;
  Repairs& operator+=(const Repairs& more);
};

/// "welded 2100 vertices, dropped 108 degenerate faces, 2 isolated vertices"; empty when nothing was repaired.
std::string to_string(const Repairs& repairs);

/// Everything below in one: degenerate and duplicate faces, welding if asked, what welding made degenerate or
/// duplicate, and last isolated vertices (those that were welded to another aren't counted again).
/// \pre positions are finite, every corner number is below V, attribute arrays are empty or full.
/// \param joined_to as for `weld_borders`.
Repairs repair(IndexedMesh& mesh, bool weld = true, std::vector<Index>* joined_to = nullptr);

/// Makes vertices with exactly equal positions (0.0 equals −0.0) one, if they lie on open borders (edges with one face)
/// or at the ends of an edge without length: the lowest numbered, whose attributes and origin stay; those joined to it
/// are left isolated. Other coincident vertices stay apart: there two closed parts touch.
///
/// Where joining all of them would give an edge a third face, the vertices at both ends of this edge are first joined
/// only as far as their faces hang together across other edges; then the pieces left open are joined pair by pair, in
/// the order of their faces, whenever no edge gets a third face. So a closed soup becomes closed, parts that touch
/// along an edge stay apart there, and which faces meet is decided by the surface, not by chance. O(V + F) where no
/// edge is in doubt, O(n log n) expected in the n corners that are.
///
/// Only where edges are in doubt are faces dropped here: those that have two corners, or all three and their order, at
/// the same positions. Otherwise this is left to the functions below.
/// \param joined_to if given, becomes V numbers: the vertex each was joined to, itself if none; empty if none was
/// joined. \return counts of welded vertices, degenerate and duplicate faces.
Repairs weld_borders(IndexedMesh& mesh, std::vector<Index>* joined_to = nullptr);

/// Drops faces two corners of which are the same vertex. Faces without area but with three different vertices (their
/// corners in a line, or at one position but not welded) stay: dropping them would open the surface.
/// \return the number dropped.
std::size_t drop_degenerate_faces(IndexedMesh& mesh);

/// Drops each face that has the same vertices as an earlier one in the same cyclic order. Coincident faces that look to
/// opposite sides are no duplicates: both stay. O(V + F). \return the number dropped.
std::size_t drop_duplicate_faces(IndexedMesh& mesh);

/// Drops vertices that no face uses; the others keep their order, and `origins` says who they were.
/// \return the number dropped.
std::size_t drop_isolated_vertices(IndexedMesh& mesh);

}  // namespace whittle::io
