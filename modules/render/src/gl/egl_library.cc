#include "gl/egl_library.hh"

#include <dlfcn.h>

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>

namespace whittle::render {

namespace {

[[noreturn]] void fail_for_want_of(const std::string& what, const std::string& package) {
  throw std::runtime_error("cannot draw: " + what + " (Debian's package " + package + " has it)");
}

void* open_libegl() {
  void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) fail_for_want_of("there is no libEGL.so.1", "libegl1");
  return library;
}

template <class Function>
void find(void* library, Function& function, const char* name) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw std::runtime_error(std::string("cannot draw: libEGL.so.1 has no ") + name);
}

EglLibrary functions_of(void* library) {
  EglLibrary egl;
  find(library, egl.bind_api, "eglBindAPI");
  find(library, egl.choose_config, "eglChooseConfig");
  find(library, egl.create_context, "eglCreateContext");
  find(library, egl.destroy_context, "eglDestroyContext");
  find(library, egl.get_current_context, "eglGetCurrentContext");
  find(library, egl.get_current_display, "eglGetCurrentDisplay");
  find(library, egl.get_current_surface, "eglGetCurrentSurface");
  find(library, egl.get_proc_address, "eglGetProcAddress");
  find(library, egl.initialize, "eglInitialize");
  find(library, egl.make_current, "eglMakeCurrent");
  find(library, egl.query_api, "eglQueryAPI");
  return egl;
}

/// The device that draws in software, by name: where there is a graphics card, too, results don't depend on it.
EGLDisplay software_display(const EglLibrary& egl) {
  const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl.get_proc_address("eglQueryDevicesEXT"));
  const auto query_string =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(egl.get_proc_address("eglQueryDeviceStringEXT"));
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.get_proc_address("eglGetPlatformDisplayEXT"));
  std::array<EGLDeviceEXT, 64> devices{};
  EGLint n_devices = 0;
  if (query_devices != nullptr && query_string != nullptr && get_display != nullptr) {
    query_devices(static_cast<EGLint>(devices.size()), devices.data(), &n_devices);
  }
  for (EGLint i = 0; i < n_devices; ++i) {
    EGLDeviceEXT const device = devices[static_cast<std::size_t>(i)];
    const char* const extensions = query_string(device, EGL_EXTENSIONS);
    if (extensions == nullptr ||
        std::string_view(extensions).find("EGL_MESA_device_software") == std::string_view::npos)
      continue;
    return get_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  }
  fail_for_want_of("EGL has no device that draws in software", "libegl-mesa0");
}

EglLibrary open_library() {
  EglLibrary egl = functions_of(open_libegl());
  egl.display = software_display(egl);
  EGLint major = 0;
  EGLint minor = 0;
  if (egl.display == EGL_NO_DISPLAY || egl.initialize(egl.display, &major, &minor) == EGL_FALSE) {
    fail_for_want_of("Mesa's driver for drawing in software doesn't start", "libgl1-mesa-dri");
  }
  return egl;
}

}  // namespace

const EglLibrary& EglLibrary::get() {
  // Never destroyed: the driver's threads may outlive static objects.
  static const EglLibrary* const library = new EglLibrary(open_library());
  return *library;
}

}  // namespace whittle::render
