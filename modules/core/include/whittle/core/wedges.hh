#pragma once

#include <span>
#include <vector>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

// Functions on the wedges of a mesh (`IndexedMesh`): the attribute values of a vertex, one on each side of a seam.

namespace whittle {

/// W, the number of wedges.
std::size_t n_wedges(const IndexedMesh& mesh);

/// The vertex of each wedge; `invalid_index` if no corner has it. Empty without a table: numbers are equal.
std::vector<Index> vertices_of_wedges(const IndexedMesh& mesh);
/// By vertex, the wedges that its faces have there, ascending. No wedges if the mesh has no table of them.
detail::IndexLists<Index> wedges_of_vertices(const IndexedMesh& mesh);

/// Makes the table of wedges if it is missing: each vertex is a wedge.
void make_wedge_table(IndexedMesh& mesh);

/// Keeps the values of some wedges, in this order; a wedge may be repeated. The table doesn't change.
/// \param kept old numbers, in the order of the new ones
void gather_wedges(IndexedMesh& mesh, std::span<const Index> kept);

/// Joins wedges of a vertex that have equal attributes, bit by bit, drops unused wedges, and numbers the others by
/// vertex. Drops the table if each vertex has one wedge.
void join_equal_wedges(IndexedMesh& mesh);

/// Keeps the lowest wedge of each vertex, and drops the table.
void drop_seams(IndexedMesh& mesh);

/// The same surface with a vertex for each wedge, and no table. Vertices are numbered by wedge; each has the origin of
/// its former vertex.
IndexedMesh split_at_wedges(const IndexedMesh& mesh);

/// A copy of positions and faces alone.
IndexedMesh without_attributes(const IndexedMesh& mesh);

/// Borders of charts and regions: edges between two faces of different regions, or with different values on both sides
/// at either end. Normals and tangents don't count, except a tangent's sign: shading may break anywhere.
/// \param regions from `face_regions`: F or empty
/// \return lower vertex first, ascending
std::vector<VertexPair> seam_edges(const IndexedMesh& mesh, std::span<const Index> regions);
/// The same with the regions of `face_regions(mesh)`.
std::vector<VertexPair> seam_edges(const IndexedMesh& mesh);

/// Joins vertices; each joined vertex gets a wedge per different set of attributes. Faces stay.
/// \param joined V; for each vertex the vertex that it becomes: itself, or an earlier vertex that becomes itself
/// \pre the mesh has origins
/// \return V; their new numbers
std::vector<Index> join_vertices(IndexedMesh& mesh, std::span<const Index> joined);

}  // namespace whittle
