#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace whittle::io {

/// The mesh file formats that are read and written.
enum class Format { obj, off, ply, stl };

inline constexpr std::array<Format, 4> all_formats{Format::obj, Format::off, Format::ply, Format::stl};

/// "obj", "off", "ply" or "stl": the ending without its dot, and what `--format` takes.
std::string_view name_of(Format format);

/// The format a file name's ending stands for; upper and lower case are the same.
/// \throw std::invalid_argument if the name has no ending or one that isn't read; formats known by name (glTF, 3DS,
/// OpenMesh's OM, compressed files…) are named and the message says what to do. It doesn't repeat the path.
Format format_of(const std::filesystem::path& path);

/// Likewise for a bare ending, with or without its dot: "ply", ".PLY".
/// \throw std::invalid_argument as `format_of`.
Format format_from_ending(std::string_view ending);

}  // namespace whittle::io
