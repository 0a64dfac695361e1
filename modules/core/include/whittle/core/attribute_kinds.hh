#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/indexed_mesh.hh"

// Files don't tell the meaning of their numbers. Labels, classes and ids must never be blended, even if they are stored
// as reals: between tree 3 and tree 7 there is no tree 5.

namespace whittle {

/// The kind of such numbers by name and type: `category` or `scalar`. The last known word of the name decides: "class",
/// "label", "id" and the like mean a category, "height", "confidence" and the like a scalar. Without a known word
/// integers are categories, unless they stand for fractions; reals are scalars.
/// \param name split into words at non-letters and capitals: "_FEATURE_ID_0", "scalar_Classification", "pointSourceId"
/// \param is_normalized whether integers stand for [0, 1] or [-1, 1]
AttributeKind kind_of_numbers(std::string_view name, ScalarType type, bool is_normalized = false);

/// Makes scalars of vertices categories if all values are whole numbers and the name doesn't mean a scalar. For
/// readers, when a mesh has all its values. Values that aren't finite are ignored.
void find_whole_categories(IndexedMesh& mesh);

/// Names of the vertex attributes that are categories; empty: kinds stay as read.
using CategoryNames = std::optional<std::vector<std::string>>;

/// Makes vertex attributes with one of the names (`has_name`) categories, and other categories scalars. Other kinds,
/// such as texture coordinates, don't change. Without names it does nothing.
void set_categories(IndexedMesh& mesh, const CategoryNames& names);

}  // namespace whittle
