#pragma once

#include <string_view>

#include "whittle/render/pixels.hh"

namespace whittle::render {

/// \throw std::runtime_error as `read_image`
Pixels read_png(std::string_view bytes);

/// \throw std::runtime_error as `read_image`
Pixels read_jpeg(std::string_view bytes);

}  // namespace whittle::render
