#pragma once

#include <cstddef>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/render/scene.hh"

namespace whittle::render {

/// A view of a scene. The projection is orthographic: `sphere` fills the square picture up to a narrow margin. Points
/// more than twice the radius before or behind its centre are not seen.
struct View {
  Sphere sphere;
  Vec3 to_eye = Vec3::UnitZ();  ///< Unit vector from the centre towards the eye.
  Vec3 up = Vec3::UnitY();      ///< Unit vector, perpendicular to `to_eye`: upwards in the picture.
};

/// The sphere's radius over the picture's half width.
inline constexpr double view_fill = 0.98;

/// The view of `sphere` from a direction. +y is up, as in glTF; +z if the direction is within about 2° of the y axis.
/// \param to_eye not 0
View view_from(const Sphere& sphere, const Vec3& to_eye);

/// n views in directions of a Fibonacci lattice around the y axis, spread evenly: direction i at height 1 - (2i + 1)/n,
/// each turned by the golden angle from the one before. \cite gonzalez_2010_fibonacci
std::vector<View> views_around(const Sphere& sphere, std::size_t n);

}  // namespace whittle::render
