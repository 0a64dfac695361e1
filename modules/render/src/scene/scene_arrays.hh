#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/render/scene.hh"

namespace whittle::render {

/// Vertex data for OpenGL.
struct SceneVertex {
  std::array<float, 3> position;  ///< in the unit of the frame's radius, from its centre
  std::array<float, 3> normal;    ///< unit length; 0 for a face without area
  std::array<float, 2> texcoord;
  std::array<float, 4> color;  ///< linear
};

/// Faces of one material of one part.
struct Batch {
  Material material;               ///< without its texture, where that isn't drawn
  const Pixels* pixels = nullptr;  ///< the scene's, of the texture; null without
  std::size_t first_index = 0;
  std::size_t n_indices = 0;
};

/// A face that blends with the background.
struct BlendFace {
  std::array<std::uint32_t, 3> vertices;
  std::uint32_t batch;
};

/// A scene as OpenGL wants it.
struct SceneArrays {
  std::vector<SceneVertex> vertices;
  std::vector<std::uint32_t> indices;  ///< of all faces that don't blend, by batch; front faces counter-clockwise
  std::vector<Batch> batches;          ///< in the order of parts and groups
  std::vector<BlendFace> blend_faces;
};

/// \throw std::invalid_argument if a face names a missing vertex or wedge, or arrays of a mesh are too short
SceneArrays scene_arrays(const Scene& scene, const Sphere& frame);

/// The positions of a part's vertices in the scene.
std::vector<Vec3> placed_positions(const Part& part);

/// Whether a face has three different corners at finite positions. \throw std::invalid_argument for a missing corner
bool can_be_drawn(const Triangle& face, const std::vector<Vec3>& positions);

}  // namespace whittle::render
