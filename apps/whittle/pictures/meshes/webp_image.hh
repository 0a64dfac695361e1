#pragma once

#include <optional>
#include <string>

#include "whittle/render/pixels.hh"

namespace whittle::app {

/// Decodes a WebP file; nothing if it is damaged, or if this program was built without libwebp.
std::optional<render::Pixels> read_webp(const std::string& bytes);

}  // namespace whittle::app
