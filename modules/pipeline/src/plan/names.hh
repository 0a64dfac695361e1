#pragma once

#include <optional>
#include <string>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/attribute_kinds.hh"
#include "whittle/core/regions.hh"
#include "whittle/scene/scene.hh"

namespace whittle {

/// Makes numbers of the input's vertices categories, or scalars, as the names say (`set_categories`).
/// \throw UnsupportedMesh if no numbers of vertices have one of the names
void take_categories(const CategoryNames& names, Scene& scene);

/// \throw UnsupportedMesh if no face attribute of the scene has one of the names
void check_regions(const RegionNames& names, const Scene& scene);

}  // namespace whittle
