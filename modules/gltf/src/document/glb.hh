#pragma once

#include <optional>
#include <string>
#include <string_view>

// The binary container, section 4.4 of the specification.

namespace whittle::gltf {

inline constexpr std::string_view glb_magic = "glTF";

/// The two parts of a GLB: the document, and the bytes of its first buffer.
struct GlbParts {
  std::string_view json;
  std::optional<std::string_view> buffer;
};

/// \return views into `bytes`. \param file its name, for messages. \throw io::ReadError
GlbParts split_glb(std::string_view bytes, const std::string& file);

/// \param buffer none is written if it is empty. \throw std::length_error for more than 4 GiB
std::string join_glb(std::string_view json, std::string_view buffer);

}  // namespace whittle::gltf
