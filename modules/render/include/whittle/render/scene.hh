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
/// Normals and colours come from the mesh. Corners without a normal, or with one of length 0, get the face's normal.
/// Degenerate faces, and faces with a corner that isn't finite, are not drawn.
struct Part {
  const IndexedMesh* mesh = nullptr;                        ///< Must outlive the scene.
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();  ///< May mirror or flatten.
  /// Per face group. Groups without a material have the default one; a mesh without groups has the first one.
  std::vector<Material> materials;
  ColorEncoding vertex_colors = ColorEncoding::linear;
};

struct Scene {
  std::vector<Part> parts;
  /// Decoded images. A texture whose image is missing here is not drawn.
  std::map<std::shared_ptr<const Image>, Pixels> images{};
};

/// The attribute with a texture's coordinates; null if the mesh lacks it.
const Attribute* texcoords_of(const IndexedMesh& mesh, const Texture& texture);

/// Decodes the images of all textures, each once. \return a line per image that isn't drawn: its name, and the reason
std::vector<std::string> decode_images(Scene& scene);

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 1;  ///< Above 0.
};

/// The smallest sphere around the middle of the bounding box that contains all drawn faces. Its radius is 1 if the
/// scene has no faces, or is one point.
Sphere bounding_sphere(const Scene& scene);

}  // namespace whittle::render
