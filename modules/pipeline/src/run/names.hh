#pragma once

#include <optional>
#include <string>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/attribute_kinds.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// Of attributes; empty: those that are found.
using Names = std::optional<std::vector<std::string>>;

/// \param attributes of the input \param what text for the message: "faces have no property"
/// \throw UnsupportedMesh if none of the attributes has one of the names
void check_names(const Names& names, const Scene& scene, const std::vector<Attribute>& attributes,
                 const std::string& what, const std::string& option);

/// Makes numbers of the input's vertices categories, or scalars, as the names say (`set_categories`).
/// \throw UnsupportedMesh if no numbers of vertices have one of the names
void take_categories(const CategoryNames& names, Scene& scene);

}  // namespace whittle
