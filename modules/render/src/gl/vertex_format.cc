#include "gl/vertex_format.hh"

#include <cstddef>
#include <iterator>

namespace whittle::render {

unsigned make_buffer(const GlFunctions& gl, GLenum target) {
  GLuint buffer = 0;
  gl.gen_buffers(1, &buffer);
  gl.bind_buffer(target, buffer);
  return buffer;
}

void set_vertex_format(const GlFunctions& gl) {
  struct Member {
    GLint size;
    std::size_t offset;
  };
  const Member members[] = {{3, offsetof(SceneVertex, position)},
                            {3, offsetof(SceneVertex, normal)},
                            {2, offsetof(SceneVertex, texcoord)},
                            {4, offsetof(SceneVertex, color)}};
  for (GLuint i = 0; i < std::size(members); ++i) {
    gl.vertex_attrib_pointer(i, members[i].size, GL_FLOAT, GL_FALSE, sizeof(SceneVertex),
                             buffer_offset(members[i].offset));
    gl.enable_vertex_attrib_array(i);
  }
}

}  // namespace whittle::render
