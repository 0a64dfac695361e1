#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

// Regions of faces. Groups and some face attributes identify parts of a surface: labels, objects, smoothing groups,
// colours of parts. Faces with equal values of all these are one region. Edges between regions are seams
// (`seam_edges`).

namespace whittle {

/// Names of the face attributes that define regions; empty: attributes for which `names_regions` holds. An attribute of
/// several components, such as "red,green,blue", also has the components' names.
using RegionNames = std::optional<std::vector<std::string>>;

/// Whether an attribute, or one of its components, has a name.
bool has_name(const Attribute& attribute, const std::string& name);

/// Whether the values of a face attribute define regions. An area is a set of faces of one value, connected over edges.
/// - `AttributeKind::category`: if areas have two faces or more in the mean. Else the values are face numbers.
/// - `AttributeKind::color`, and reals that are all whole: if there are at most 256 values, and areas have eight faces
/// or
///   more in the mean. Else they may shade a surface, or measure something.
/// \param attribute of the mesh's faces
bool names_regions(const IndexedMesh& mesh, const Attribute& attribute);

/// The region of each face: F numbers from 0, in the order of their first faces. Empty for a single region. Groups
/// always define regions, also with `names`.
std::vector<Index> face_regions(const IndexedMesh& mesh, const RegionNames& names = {});

/// The area of each face: faces connected over edges that aren't seams. F numbers; `invalid_index` for an area without
/// seams. Empty without seams. \param seams edges, lower vertex first, ascending
std::vector<Index> seam_areas(const IndexedMesh& mesh, std::span<const VertexPair> seams);

}  // namespace whittle
