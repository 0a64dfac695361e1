#pragma once

#include <array>

#include "options/values.hh"
#include "whittle/engine/simplify.hh"

namespace whittle::app {

/// The values of --fit.
inline constexpr std::array<Choice<Fit>, 3> fits{{{"mean", Fit::mean}, {"balanced", Fit::balanced}, {"max", Fit::max}}};

/// What the help says of --fit.
inline constexpr char fit_meaning[] =
    "what polish brings down. mean: the mean distance; balanced: that, but no vertex may stick out far; max: the "
    "largest distance";

}  // namespace whittle::app
