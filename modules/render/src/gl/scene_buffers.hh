#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "gl/functions.hh"
#include "scene/scene_arrays.hh"

namespace whittle::render {

/// A scene in OpenGL's memory. All functions need the context to be current. The context frees its objects.
class SceneBuffers {
 public:
  /// \param arrays of a scene that is still there
  /// \throw std::invalid_argument if the array of an image doesn't have its size
  SceneBuffers(const GlFunctions& gl, SceneArrays arrays);

  /// Draws all faces into the framebuffer: first opaque faces, then blended faces from back to front.
  /// \param to_eye unit vector
  void draw(unsigned program, const Eigen::Vector3f& to_eye);
  /// The faces that don't blend.
  void draw_solid_faces(unsigned program);
  /// The others, from back to front. \param to_eye unit vector
  void draw_blend_faces(unsigned program, const Eigen::Vector3f& to_eye);

 private:
  void upload_arrays();
  unsigned texture_of(const Batch& batch);
  unsigned upload(const Pixels& pixels, const std::array<Wrap, 2>& wrap);
  void use(unsigned program, std::size_t batch);
  std::vector<BlendFace> from_back_to_front(const Eigen::Vector3f& to_eye) const;

  const GlFunctions& gl_;
  SceneArrays arrays_;
  std::map<std::pair<const Pixels*, std::array<Wrap, 2>>, unsigned> textures_;
  std::vector<unsigned> texture_of_batch_;
  unsigned white_ = 0;  ///< for materials without a texture
  unsigned solid_vertex_array_ = 0;
  unsigned blend_vertex_array_ = 0;
  unsigned blend_indices_ = 0;
};

}  // namespace whittle::render
