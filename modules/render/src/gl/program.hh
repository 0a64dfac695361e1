#pragma once

#include "gl/functions.hh"

namespace whittle::render {

/// Compiles and links shaders. The context frees the program.
/// \throw std::runtime_error if OpenGL refuses them
unsigned make_program(const GlFunctions& gl, const char* vertex_source, const char* fragment_source);

/// Makes and binds a framebuffer of samples: linear colours, unrounded, and depths. The context frees it.
/// \throw std::runtime_error if OpenGL has none of that size
void make_framebuffer(const GlFunctions& gl, int width, int height);

/// \throw std::runtime_error if an OpenGL function has failed since the last check
void check_errors(const GlFunctions& gl);

}  // namespace whittle::render
