#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/indexed_mesh.hh"

// Files don't say what their numbers mean. Labels, classes and ids must never be blended, also where they are stored as
// reals: between tree 3 and tree 7 there is no tree 5.

namespace whittle {

/// The kind of such numbers by their name and type: `category` or `scalar`. The last word of the name that is known
/// decides: "class", "label", "id" and the like name things, "height", "confidence" and the like measure something.
/// Without a known word integers name things, unless they stand for fractions, and reals don't.
/// \param name words are parted by anything but letters, and by capitals: "_FEATURE_ID_0", "scalar_Classification",
///        "pointSourceId" \param is_normalized whether integers stand for [0, 1] or [-1, 1]
AttributeKind kind_of_numbers(std::string_view name, ScalarType type, bool is_normalized = false);

/// Takes numbers of vertices for categories if all of them are whole and their names don't say that they measure
/// something. For readers, when a mesh has all its values. Numbers that are not finite are passed over.
void find_whole_categories(IndexedMesh& mesh);

/// The names of the attributes of vertices that are categories; empty: as files are read.
using CategoryNames = std::optional<std::vector<std::string>>;

/// Makes numbers of vertices categories if they have one of the names (`has_name`), and all others scalars. Leaves
/// other kinds, such as texture coordinates. Without names it does nothing.
void set_categories(IndexedMesh& mesh, const CategoryNames& names);

}  // namespace whittle
