#pragma once

#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/render/scene.hh"

namespace whittle::render {

/// From where a scene is looked at. The projection is orthographic: `sphere` fills the square picture but for a narrow
/// margin. What lies more than twice the radius before or behind its centre is not seen.
struct View {
  Sphere sphere;
  Vec3 to_eye = Vec3::UnitZ();  ///< Unit vector from the centre towards the eye.
  Vec3 up = Vec3::UnitY();      ///< Unit vector, perpendicular to `to_eye`: upwards in the picture.
};

/// The share of the picture's half width that the sphere's radius takes.
inline constexpr double view_fill = 0.98;

/// Looks at `sphere` from a direction. +y is up, as in glTF; where the direction is within about 2° of the y axis, +z
/// is. \param to_eye not 0
View view_from(const Sphere& sphere, const Vec3& to_eye);

/// n views with directions spread evenly: those of a Fibonacci lattice around the y axis, direction i at height
/// 1 - (2i + 1)/n, each turned by the golden angle from the one before. \cite gonzalez_2010_fibonacci
std::vector<View> views_around(const Sphere& sphere, std::size_t n);

}  // namespace whittle::render
