#include "gl/program.hh"

#include <stdexcept>
#include <string>

namespace whittle::render {

namespace {

unsigned compile(const GlFunctions& gl, GLenum kind, const char* text) {
  const unsigned shader = gl.create_shader(kind);
  gl.shader_source(shader, 1, &text, nullptr);
  gl.compile_shader(shader);
  return shader;
}

void attach_renderbuffer(const GlFunctions& gl, GLenum attachment, GLenum format, int width, int height) {
  GLuint buffer = 0;
  gl.gen_renderbuffers(1, &buffer);
  gl.bind_renderbuffer(GL_RENDERBUFFER, buffer);
  gl.renderbuffer_storage(GL_RENDERBUFFER, format, width, height);
  gl.framebuffer_renderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

}  // namespace

unsigned make_program(const GlFunctions& gl, const char* vertex_source, const char* fragment_source) {
  const unsigned program = gl.create_program();
  gl.attach_shader(program, compile(gl, GL_VERTEX_SHADER, vertex_source));
  gl.attach_shader(program, compile(gl, GL_FRAGMENT_SHADER, fragment_source));
  gl.link_program(program);
  GLint is_linked = GL_FALSE;
  gl.get_program_iv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked != GL_TRUE) throw std::runtime_error("cannot draw: OpenGL refuses the shaders");
  return program;
}

void make_framebuffer(const GlFunctions& gl, int width, int height) {
  GLuint framebuffer = 0;
  gl.gen_framebuffers(1, &framebuffer);
  gl.bind_framebuffer(GL_FRAMEBUFFER, framebuffer);
  attach_renderbuffer(gl, GL_COLOR_ATTACHMENT0, GL_RGBA32F, width, height);
  attach_renderbuffer(gl, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height);
  if (gl.check_framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("cannot draw: OpenGL has no framebuffer of that size");
  }
  gl.viewport(0, 0, width, height);
}

void check_errors(const GlFunctions& gl) {
  const GLenum error = gl.get_error();
  if (error == GL_OUT_OF_MEMORY) throw std::runtime_error("cannot draw: OpenGL lacks memory");
  if (error != GL_NO_ERROR) throw std::runtime_error("cannot draw: OpenGL error " + std::to_string(error));
}

}  // namespace whittle::render
