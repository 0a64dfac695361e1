#pragma once

#include <array>

#include "options/values.hh"
#include "whittle/engine/simplify.hh"

namespace whittle::app {

/// The values of --effort.
inline constexpr std::array<Choice<Effort>, 3> efforts{
    {{"fast", Effort::fast}, {"normal", Effort::normal}, {"best", Effort::best}}};

/// What the help says of --effort.
inline constexpr char effort_meaning[] =
    "fast: '--cost quadric', on large meshes memoryless, no polish; normal: '--cost memoryless --polish 1', and "
    "polish once on the way; best: '--cost memoryless --polish 2', polish three times on the way, and edges are "
    "flipped where that helps";

}  // namespace whittle::app
