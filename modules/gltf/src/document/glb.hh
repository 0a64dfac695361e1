#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "whittle/core/bytes/glb.hh"

// Reads the binary container; `join_glb` writes it.

namespace whittle::gltf {

/// The two parts of a GLB: the document, and the bytes of its first buffer.
struct GlbParts {
  std::string_view json;
  std::optional<std::string_view> buffer;
};

/// \return views into `bytes`. \param file its name, for messages. \throw io::ReadError
GlbParts split_glb(std::string_view bytes, const std::string& file);

}  // namespace whittle::gltf
