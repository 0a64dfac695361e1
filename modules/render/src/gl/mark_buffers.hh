#pragma once

#include <vector>

#include "gl/functions.hh"
#include "scene/scene_arrays.hh"
#include "whittle/render/figure.hh"

namespace whittle::render {

/// Lines or dots in OpenGL's memory. All functions need the context to be current. The context frees what is made here.
class MarkBuffers {
 public:
  /// \param mode GL_LINES or GL_POINTS
  MarkBuffers(const GlFunctions& gl, GLenum mode, const std::vector<SceneVertex>& vertices);

  void draw() const;

 private:
  const GlFunctions& gl_;
  GLenum mode_;
  GLsizei n_vertices_;
  unsigned vertex_array_ = 0;
};

/// The vertices of lines and dots. \param frame as of `scene_arrays`
std::vector<SceneVertex> vertices_of(const Lines& lines, const Sphere& frame);
std::vector<SceneVertex> vertices_of(const Dots& dots, const Sphere& frame);

}  // namespace whittle::render
