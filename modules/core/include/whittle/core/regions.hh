#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

// What faces have beside corners may name things: the groups of a mesh, and such face attributes as labels, objects,
// smoothing groups, and the colours of parts. A region is all faces that have the same of all of these. Edges between
// regions are seams (`seam_edges`).

namespace whittle {

/// The names of the face attributes that name regions; empty: those of which `names_regions` holds. An attribute of
/// several components, as "red,green,blue", has their names, too.
using RegionNames = std::optional<std::vector<std::string>>;

/// Whether an attribute has a name, or one of its components has.
bool has_name(const Attribute& attribute, const std::string& name);

/// Whether the values of a face attribute name things that lie on the surface in areas. An area is a set of faces of
/// one value that are connected over edges.
/// - `AttributeKind::category`: areas have two faces in the mean, and more. Else the numbers are those of the faces.
/// - `AttributeKind::color`, and reals that are all whole: there are 256 values at most, and areas have eight faces in
///   the mean, and more. Else they may shade a surface, or measure something.
/// \param attribute of the mesh's faces
bool names_regions(const IndexedMesh& mesh, const Attribute& attribute);

/// The region of each face: F numbers from 0, in the order of their first faces. Empty if there is but one. Groups name
/// regions, whatever the names are.
std::vector<Index> face_regions(const IndexedMesh& mesh, const RegionNames& names = {});

/// The area of each face: of those that are connected over edges that are no seams. F numbers; `invalid_index` where no
/// edge of the area is a seam. Empty if there is no seam. \param seams edges, lower vertex first, ascending
std::vector<Index> seam_areas(const IndexedMesh& mesh, std::span<const VertexPair> seams);

}  // namespace whittle
