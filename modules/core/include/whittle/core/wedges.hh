#pragma once

#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

// What to do with the wedges of a mesh (`IndexedMesh`): the attribute values of a vertex, one on each side of a seam.

namespace whittle {

/// W.
std::size_t n_wedges(const IndexedMesh& mesh);

/// The vertex of each wedge; `invalid_index` if no corner has it. Empty without a table: then it has the same number.
std::vector<Index> vertices_of_wedges(const IndexedMesh& mesh);

/// Makes the table of wedges, if there is none: each vertex is a wedge.
void make_wedge_table(IndexedMesh& mesh);

/// Keeps the values of some wedges, in this order; one may come several times. The table stays as it is.
/// \param kept old numbers, in the order of the new ones
void gather_wedges(IndexedMesh& mesh, std::span<const Index> kept);

/// Joins the wedges of a vertex that have equal attributes, bit by bit, and drops those that no corner has. The others
/// are numbered by vertex. The table goes, too, where each vertex has one wedge.
void join_equal_wedges(IndexedMesh& mesh);

/// Leaves one wedge to each vertex: that of the lowest number. The table goes.
void drop_seams(IndexedMesh& mesh);

/// The same surface with a vertex for each wedge, and no table. Vertices are numbered by wedge; each has the origin of
/// the vertex that it was.
IndexedMesh split_at_wedges(const IndexedMesh& mesh);

/// Positions and faces alone.
IndexedMesh without_attributes(const IndexedMesh& mesh);

/// The edges that are borders of charts or regions: between two faces of different regions, or with different values
/// on both sides at either end. Normals and tangents don't count, but for a tangent's sign: shading may break anywhere.
/// \param regions as `face_regions` has them: F or empty
/// \return lower vertex first, ascending
std::vector<VertexPair> seam_edges(const IndexedMesh& mesh, std::span<const Index> regions);
/// With the regions that groups and face attributes name by themselves.
std::vector<VertexPair> seam_edges(const IndexedMesh& mesh);

/// Makes several vertices one, with a wedge for each where their attributes differ. Faces stay.
/// \param joined V; for each vertex the one that it becomes, which is none after it and becomes itself
/// \pre the mesh has origins \return V; their new numbers
std::vector<Index> join_vertices(IndexedMesh& mesh, std::span<const Index> joined);

}  // namespace whittle
