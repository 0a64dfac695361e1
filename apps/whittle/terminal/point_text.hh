#pragma once

#include <string>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::app {

/// A point of a mesh: "500099.123 5600000.5 119". \param extent the diagonal of the mesh's box: digits go down to a
/// thousandth of its first one, however far the mesh lies from the origin
std::string point_text(const Vec3& point, double extent);

}  // namespace whittle::app
