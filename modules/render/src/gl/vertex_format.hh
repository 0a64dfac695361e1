#pragma once

#include <vector>

#include "gl/functions.hh"
#include "scene/scene_arrays.hh"

namespace whittle::render {

/// A place in a buffer, as OpenGL wants it: a pointer.
inline const void* buffer_offset(std::size_t bytes) {
  return reinterpret_cast<const void*>(bytes);  // NOLINT(performance-no-int-to-ptr)
}

/// Makes and binds a buffer.
unsigned make_buffer(const GlFunctions& gl, GLenum target);

template <class T>
void fill_buffer(const GlFunctions& gl, GLenum target, const std::vector<T>& values, GLenum usage) {
  gl.buffer_data(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), usage);
}

/// Tells the bound vertex array that the bound buffer has `SceneVertex`es.
void set_vertex_format(const GlFunctions& gl);

}  // namespace whittle::render
