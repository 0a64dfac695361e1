#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/render/texture.hh"

namespace whittle::render {

/// What the opacity of a colour does.
enum class AlphaMode : std::uint8_t {
  opaque,  ///< Nothing.
  mask,    ///< Below the cutoff nothing is drawn; from it on, the surface is opaque.
  blend    ///< What is behind shines through.
};

/// How a surface looks: the product of factor, texture and vertex colour.
struct Material {
  std::array<double, 4> base_color = {1, 1, 1, 1};    ///< Linear red, green, blue, and opacity; each in [0, 1].
  std::shared_ptr<const Texture> base_color_texture;  ///< Or null.
  /// The attribute of the mesh with the texture's coordinates. Without it the mesh is drawn without the texture.
  std::string texcoord = "TEXCOORD_0";
  /// From the mesh's coordinates to the texture's: glTF's KHR_texture_transform. For OBJ: (u, v) to (u, 1 - v).
  Eigen::Affine2d texcoord_transform = Eigen::Affine2d::Identity();
  AlphaMode alpha_mode = AlphaMode::opaque;
  double alpha_cutoff = 0.5;
  bool double_sided = false;  ///< Otherwise back faces are not drawn.
};

/// How numbers are related to light.
enum class ColorEncoding : std::uint8_t {
  linear,  ///< As vertex colours of glTF.
  srgb     ///< As vertex colours of most other files.
};

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
};

struct Sphere {
  Vec3 center = Vec3::Zero();
  double radius = 1;  ///< Above 0.
};

/// A sphere that contains all that is drawn: around the middle of the bounding box, as small as can be there. Its
/// radius is 1 where the scene has no faces, or is one point.
Sphere bounding_sphere(const Scene& scene);

}  // namespace whittle::render
