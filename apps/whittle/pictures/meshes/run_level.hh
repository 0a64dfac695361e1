#pragma once

#include "pictures/draw_meshes.hh"

namespace whittle::app {

/// The surface at the view's place in a run: its shape alone. The run goes there.
ShownSurface level_of_run(progressive::Replay& run, const PictureView& view);

}  // namespace whittle::app
