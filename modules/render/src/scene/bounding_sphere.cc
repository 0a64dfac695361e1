#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/scene_arrays.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle::render {

namespace {

template <class Use>
void for_each_drawn_corner(const Scene& scene, const Use& use) {
  for (const Part& part : scene.parts) {
    if (part.mesh == nullptr) throw std::invalid_argument("a part of a scene to draw has no mesh");
    const std::vector<Vec3> positions = placed_positions(part);
    for (const Triangle& face : part.mesh->faces) {
      if (!can_be_drawn(face, positions)) continue;
      for (const Index v : face) use(positions[v]);
    }
  }
}

}  // namespace

Sphere bounding_sphere(const Scene& scene) {
  Box box;
  for_each_drawn_corner(scene, [&](const Vec3& corner) { box.extend(corner); });
  if (box.isEmpty()) return {};
  Sphere sphere{center_of(box), 0};
  for_each_drawn_corner(
      scene, [&](const Vec3& corner) { sphere.radius = std::max(sphere.radius, (corner - sphere.center).norm()); });
  if (!(sphere.radius > 0)) sphere.radius = 1;
  return sphere;
}

}  // namespace whittle::render
