#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

// The binary container of glTF 2.0: section 4.4 of its specification.

namespace whittle {

inline constexpr std::string_view glb_magic = "glTF";
inline constexpr std::uint32_t glb_version = 2;
inline constexpr std::size_t glb_header_size = 12;
inline constexpr std::size_t glb_chunk_header_size = 8;
/// Types of chunks.
inline constexpr std::uint32_t glb_json_chunk = 0x4E4F534A;
inline constexpr std::uint32_t glb_buffer_chunk = 0x004E4942;

/// \param buffer left out if empty. \throw std::length_error for more than 4 GiB
std::string join_glb(std::string_view json, std::string_view buffer);

}  // namespace whittle
