#pragma once

#include <cstdint>
#include <vector>

#include "whittle/render/picture.hh"

namespace whittle::bake {

/// Gives each pixel without a value the mean of its neighbours that have one, again and again, from the border of the
/// values outwards. \param is_set per pixel; at least one is \param picture values of its pixels
void fill_outwards(std::vector<std::uint8_t> is_set, render::Picture& picture);

}  // namespace whittle::bake
