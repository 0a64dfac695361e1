#pragma once

#include <GL/glcorearb.h>

// The functions of OpenGL 3.3 that are used. They are found at run time: whoever doesn't draw needs no OpenGL.

namespace whittle::render {

// Type, member, name.
#define WHITTLE_GL_FUNCTIONS(X)                                                                \
  X(PFNGLACTIVETEXTUREPROC, active_texture, "glActiveTexture")                                 \
  X(PFNGLATTACHSHADERPROC, attach_shader, "glAttachShader")                                    \
  X(PFNGLBINDBUFFERPROC, bind_buffer, "glBindBuffer")                                          \
  X(PFNGLBINDFRAMEBUFFERPROC, bind_framebuffer, "glBindFramebuffer")                           \
  X(PFNGLBINDRENDERBUFFERPROC, bind_renderbuffer, "glBindRenderbuffer")                        \
  X(PFNGLBINDTEXTUREPROC, bind_texture, "glBindTexture")                                       \
  X(PFNGLBINDVERTEXARRAYPROC, bind_vertex_array, "glBindVertexArray")                          \
  X(PFNGLBLENDFUNCSEPARATEPROC, blend_func_separate, "glBlendFuncSeparate")                    \
  X(PFNGLBUFFERDATAPROC, buffer_data, "glBufferData")                                          \
  X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, check_framebuffer_status, "glCheckFramebufferStatus")     \
  X(PFNGLCLEARCOLORPROC, clear_color, "glClearColor")                                          \
  X(PFNGLCLEARPROC, clear, "glClear")                                                          \
  X(PFNGLCOMPILESHADERPROC, compile_shader, "glCompileShader")                                 \
  X(PFNGLCREATEPROGRAMPROC, create_program, "glCreateProgram")                                 \
  X(PFNGLCREATESHADERPROC, create_shader, "glCreateShader")                                    \
  X(PFNGLDEPTHFUNCPROC, depth_func, "glDepthFunc")                                             \
  X(PFNGLDEPTHMASKPROC, depth_mask, "glDepthMask")                                             \
  X(PFNGLDISABLEPROC, disable, "glDisable")                                                    \
  X(PFNGLDRAWARRAYSPROC, draw_arrays, "glDrawArrays")                                          \
  X(PFNGLDRAWELEMENTSPROC, draw_elements, "glDrawElements")                                    \
  X(PFNGLENABLEPROC, enable, "glEnable")                                                       \
  X(PFNGLENABLEVERTEXATTRIBARRAYPROC, enable_vertex_attrib_array, "glEnableVertexAttribArray") \
  X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, framebuffer_renderbuffer, "glFramebufferRenderbuffer")   \
  X(PFNGLGENBUFFERSPROC, gen_buffers, "glGenBuffers")                                          \
  X(PFNGLGENERATEMIPMAPPROC, generate_mipmap, "glGenerateMipmap")                              \
  X(PFNGLGENFRAMEBUFFERSPROC, gen_framebuffers, "glGenFramebuffers")                           \
  X(PFNGLGENRENDERBUFFERSPROC, gen_renderbuffers, "glGenRenderbuffers")                        \
  X(PFNGLGENTEXTURESPROC, gen_textures, "glGenTextures")                                       \
  X(PFNGLGENVERTEXARRAYSPROC, gen_vertex_arrays, "glGenVertexArrays")                          \
  X(PFNGLGETERRORPROC, get_error, "glGetError")                                                \
  X(PFNGLGETPROGRAMIVPROC, get_program_iv, "glGetProgramiv")                                   \
  X(PFNGLGETUNIFORMLOCATIONPROC, get_uniform_location, "glGetUniformLocation")                 \
  X(PFNGLLINKPROGRAMPROC, link_program, "glLinkProgram")                                       \
  X(PFNGLPOLYGONOFFSETPROC, polygon_offset, "glPolygonOffset")                                 \
  X(PFNGLREADPIXELSPROC, read_pixels, "glReadPixels")                                          \
  X(PFNGLRENDERBUFFERSTORAGEPROC, renderbuffer_storage, "glRenderbufferStorage")               \
  X(PFNGLSHADERSOURCEPROC, shader_source, "glShaderSource")                                    \
  X(PFNGLTEXIMAGE2DPROC, tex_image_2d, "glTexImage2D")                                         \
  X(PFNGLTEXPARAMETERIPROC, tex_parameter_i, "glTexParameteri")                                \
  X(PFNGLUNIFORM1FPROC, uniform_1f, "glUniform1f")                                             \
  X(PFNGLUNIFORM1IPROC, uniform_1i, "glUniform1i")                                             \
  X(PFNGLUNIFORM3FPROC, uniform_3f, "glUniform3f")                                             \
  X(PFNGLUNIFORM4FPROC, uniform_4f, "glUniform4f")                                             \
  X(PFNGLUNIFORMMATRIX4FVPROC, uniform_matrix_4fv, "glUniformMatrix4fv")                       \
  X(PFNGLUSEPROGRAMPROC, use_program, "glUseProgram")                                          \
  X(PFNGLVERTEXATTRIBPOINTERPROC, vertex_attrib_pointer, "glVertexAttribPointer")              \
  X(PFNGLVIEWPORTPROC, viewport, "glViewport")

struct GlFunctions {
#define WHITTLE_GL_MEMBER(type, member, name) type member = nullptr;
  WHITTLE_GL_FUNCTIONS(WHITTLE_GL_MEMBER)
#undef WHITTLE_GL_MEMBER
};

}  // namespace whittle::render
