#pragma once

#include "gl/functions.hh"

namespace whittle::render {

struct EglLibrary;

/// An OpenGL 3.3 context that draws in software and has no window. It owns all that is made in it: buffers, textures.
class GlContext {
 public:
  /// \throw std::runtime_error, one line, if this machine has no such thing
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  const GlFunctions& gl() const { return gl_; }

  /// Makes the context current on this thread while it lives. The thread's own context, if EGL made it, comes back.
  class Use {
   public:
    /// \throw std::runtime_error if EGL refuses
    explicit Use(const GlContext& context);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    const EglLibrary& egl_;
    unsigned api_;
    void* display_;
    void* draw_surface_;
    void* read_surface_;
    void* context_;
  };

 private:
  const EglLibrary& egl_;
  void* context_ = nullptr;
  GlFunctions gl_;
};

}  // namespace whittle::render
