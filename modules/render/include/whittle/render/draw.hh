#pragma once

#include <memory>
#include <optional>
#include <string>

#include "whittle/render/picture.hh"
#include "whittle/render/scene.hh"
#include "whittle/render/view.hh"

// Draws scenes with OpenGL in software: no window, no graphics card. docs/dev/render.md has the shading.

namespace whittle::render {

struct DrawOptions {
  int size = 512;   ///< Width and height of the picture, pixels, [1, 4096].
  int samples = 4;  ///< Samples a pixel, a square number: 1, 4, 9, …, 64. size · √samples is at most 8192.
};

/// The background of all pictures: sRGB, the same number for red, green and blue. Middle grey.
inline constexpr float background = 128.0F / 255;

/// The reason why this machine can't draw, one line; empty if it can.
std::optional<std::string> why_nothing_can_be_drawn();

/// Draws one scene from many views. Copies the scene's data.
class Renderer {
 public:
  /// \param frame the sphere of the views; positions are exact to 1e-7 of its radius
  /// \throw std::invalid_argument if `options` are out of range, a face names a missing vertex or wedge, or the length
  ///        of an image's array doesn't fit its size
  /// \throw std::runtime_error without OpenGL, or if it lacks memory
  Renderer(const Scene& scene, const Sphere& frame, const DrawOptions& options = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Draws one view. Equal scenes, views and options give equal bytes on one machine. Each colour is a multiple of
  /// 1/255. \throw std::runtime_error if OpenGL fails
  Picture draw(const View& view);

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Draws one picture of a scene. For several, a `Renderer` takes less time. \throw as `Renderer`
Picture draw(const Scene& scene, const View& view, const DrawOptions& options = {});

}  // namespace whittle::render
