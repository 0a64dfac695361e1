#include "gl/context.hh"

#include <stdexcept>
#include <string>

#include "gl/egl_library.hh"

namespace whittle::render {

namespace {

EGLContext make_egl_context(const EglLibrary& egl) {
  egl.bind_api(EGL_OPENGL_API);  // of this thread
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint n_configs = 0;
  if (egl.choose_config(egl.display, wanted, &config, 1, &n_configs) == EGL_FALSE || n_configs == 0) return nullptr;
  const EGLint version[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  return egl.create_context(egl.display, config, EGL_NO_CONTEXT, version);
}

template <class Function>
void find(const EglLibrary& egl, Function& function, const char* name) {
  function = reinterpret_cast<Function>(egl.get_proc_address(name));
  if (function == nullptr) throw std::runtime_error(std::string("cannot draw: OpenGL has no ") + name);
}

}  // namespace

GlContext::GlContext() : egl_(EglLibrary::get()) {
#define WHITTLE_GL_FIND(type, member, name) find(egl_, gl_.member, name);
  WHITTLE_GL_FUNCTIONS(WHITTLE_GL_FIND)
#undef WHITTLE_GL_FIND
  context_ = make_egl_context(egl_);
  if (context_ == nullptr) throw std::runtime_error("cannot draw: EGL makes no context of OpenGL 3.3");
}

GlContext::~GlContext() { egl_.destroy_context(egl_.display, context_); }

GlContext::Use::Use(const GlContext& context)
    : egl_(context.egl_),
      api_(egl_.query_api()),
      display_(egl_.get_current_display()),
      draw_surface_(egl_.get_current_surface(EGL_DRAW)),
      read_surface_(egl_.get_current_surface(EGL_READ)),
      context_(egl_.get_current_context()) {
  egl_.bind_api(EGL_OPENGL_API);
  if (egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_) == EGL_FALSE) {
    throw std::runtime_error("cannot draw: EGL can't use its context without a window");
  }
}

GlContext::Use::~Use() {
  egl_.make_current(egl_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != EGL_NO_CONTEXT) egl_.make_current(display_, draw_surface_, read_surface_, context_);
  egl_.bind_api(api_);
}

}  // namespace whittle::render
