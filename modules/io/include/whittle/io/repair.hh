#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "whittle/engine/indexed_mesh.hh"

namespace whittle::io {

/// How often each kind of repair was needed.
struct Repairs {
  std::size_t welded_vertices = 0;        ///< Vertices that became one with an exact duplicate.
  std::size_t triangulated_polygons = 0;  ///< Faces with more than three corners.
  std::size_t degenerate_faces = 0;       ///< Faces dropped because two corners are one vertex.
  std::size_t duplicate_faces = 0;        ///< Faces dropped because an earlier one has the same corners, same side up.
  std::size_t isolated_vertices = 0;      ///< Vertices dropped because no face uses them.

  /// Name and count of each kind, in this order; the names are the keys of `repairs` in the JSON report.
  std::array<std::pair<std::string_view, std::size_t>, 5> entries() const;
  bool any() const;
};

/// "welded 2100 vertices, dropped 108 degenerate faces"; empty when nothing was repaired.
std::string to_string(const Repairs& repairs);

/// All of the repairs below, in the order that makes the result a fixed point: a second call changes nothing.
/// \pre every corner number is below V; attribute arrays are empty or full.
Repairs repair(IndexedMesh& mesh, bool weld = true);

/// Makes vertices with exactly equal positions (0.0 equals −0.0) that lie on open borders one, the lowest numbered,
/// whose attributes and origin stay. An open border is an edge with one face. Where joining all vertices at a position
/// would give an edge a third face, the ends of that edge are joined only as far as their faces hang together over
/// other edges. O(V + F). Faces are renumbered, none is dropped; vertices joined to another are left isolated.
/// \return the number of vertices that became another.
std::size_t weld_borders(IndexedMesh& mesh);

/// Drops faces two corners of which are the same vertex. Faces without area but with three vertices stay: dropping
/// them would open the surface. \return the number dropped.
std::size_t drop_degenerate_faces(IndexedMesh& mesh);

/// Drops each face that has the same vertices as an earlier one in the same cyclic order. Coincident faces that look to
/// opposite sides are no duplicates: both stay. O(V + F). \return the number dropped.
std::size_t drop_duplicate_faces(IndexedMesh& mesh);

/// Drops vertices that no face uses; the others keep their order, and `origins` says who they were.
/// \return the number dropped.
std::size_t drop_isolated_vertices(IndexedMesh& mesh);

}  // namespace whittle::io
