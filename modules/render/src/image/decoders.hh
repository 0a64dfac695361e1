#pragma once

#include <string_view>

#include "whittle/render/texture.hh"

namespace whittle::render {

/// \throw std::runtime_error as `read_image`
Texture read_png(std::string_view bytes);

/// \throw std::runtime_error as `read_image`
Texture read_jpeg(std::string_view bytes);

}  // namespace whittle::render
