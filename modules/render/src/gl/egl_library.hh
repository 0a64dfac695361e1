#pragma once

// Without these EGL's headers include X11's.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace whittle::render {

/// libEGL, and its display that draws in software. One for the whole process; it is never unloaded.
struct EglLibrary {
  PFNEGLBINDAPIPROC bind_api = nullptr;
  PFNEGLCHOOSECONFIGPROC choose_config = nullptr;
  PFNEGLCREATECONTEXTPROC create_context = nullptr;
  PFNEGLDESTROYCONTEXTPROC destroy_context = nullptr;
  PFNEGLGETCURRENTCONTEXTPROC get_current_context = nullptr;
  PFNEGLGETCURRENTDISPLAYPROC get_current_display = nullptr;
  PFNEGLGETCURRENTSURFACEPROC get_current_surface = nullptr;
  PFNEGLGETPROCADDRESSPROC get_proc_address = nullptr;
  PFNEGLINITIALIZEPROC initialize = nullptr;
  PFNEGLMAKECURRENTPROC make_current = nullptr;
  PFNEGLQUERYAPIPROC query_api = nullptr;

  EGLDisplay display = EGL_NO_DISPLAY;

  /// \throw std::runtime_error, one line, if libEGL or the driver is missing
  static const EglLibrary& get();
};

}  // namespace whittle::render
