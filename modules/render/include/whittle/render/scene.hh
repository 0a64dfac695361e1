#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/material/material.hh"
#include "whittle/render/pixels.hh"

namespace whittle::render {

/// A mesh at its place in a scene.
///
/// Normals and colours are those of the mesh. Corners without a normal, or with one of length 0, get that of their
/// face. Degenerate faces, and those with a corner that isn't finite, are not drawn.
struct Part {
  const IndexedMesh* mesh = nullptr;                        ///< Has to outlive the scene.
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();  ///< May mirror or flatten.
  /// By face group. Groups without a material have the default one; a mesh without groups has the first one.
  std::vector<Material> materials;
  ColorEncoding vertex_colors = ColorEncoding::linear;
};

struct Scene {
  std::vector<Part> parts;
  /// Decoded ones. A texture whose image isn't among them is not drawn.
  std::map<std::shared_ptr<const Image>, Pixels> images{};
};

/// Decodes the images of all textures, each once. \return a line for each that isn't drawn: its name, and why
std::vector<std::string> decode_images(Scene& scene);

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 1;  ///< Above 0.
};

/// A sphere that contains all that is drawn: around the middle of the bounding box, as small as can be there. Its
/// radius is 1 where the scene has no faces, or is one point.
Sphere bounding_sphere(const Scene& scene);

}  // namespace whittle::render
