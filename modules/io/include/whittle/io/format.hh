#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace whittle::io {

/// The mesh file formats that are read and written.
enum class Format { obj, off, ply, stl };

namespace detail {

/// All that is known of a format (src/format/format_row.hh). Each format defines its row among its own sources.
struct FormatRow;
extern const FormatRow obj_row;
extern const FormatRow off_row;
extern const FormatRow ply_row;
extern const FormatRow stl_row;

/// The table of formats, in the order of `Format`. Whatever asks about formats asks this table.
inline constexpr std::array format_table{&obj_row, &off_row, &ply_row, &stl_row};

}  // namespace detail

inline constexpr auto all_formats = [] {
  std::array<Format, detail::format_table.size()> formats{};
  for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = static_cast<Format>(i);
  return formats;
}();

/// "obj": what `--format` takes and JSON reports have. Also an extension of the format's files.
std::string_view name_of(Format format);

/// {"obj"}: the extensions of the format's files, lower case, without the dot.
std::span<const std::string_view> extensions_of(Format format);

/// "OBJ": for sentences.
std::string_view title_of(Format format);

/// Whether the format is written as text or as binary data, by `WriteOptions::ascii`. The others are written one way.
bool has_text_and_binary(Format format);

/// "obj, off, ply, stl": the names of all formats.
std::string format_names(std::string_view separator = ", ");

/// "OBJ, OFF, PLY or STL": the titles of all formats, for sentences.
std::string format_titles();

/// "PLY or STL": the titles of the formats that `has_text_and_binary`.
std::string titles_with_text_and_binary();

/// Whether a file name ends in ".gz", in upper or lower case: the file is packed with gzip.
bool has_gzip_extension(const std::filesystem::path& path);

/// The format that a file name's extension stands for, in upper or lower case: of "mesh.ply.gz" the one before ".gz".
/// \throw std::invalid_argument if there is no extension, or none of a supported format. The message says what to do.
/// It names formats that are known but not supported (glTF, 3DS, OpenMesh's OM, archives…). It doesn't repeat
/// the path.
Format format_of(const std::filesystem::path& path);

/// Likewise for an extension, with or without its dot: "ply", ".PLY".
/// \throw std::invalid_argument as `format_of`.
Format format_from_extension(std::string_view extension);

}  // namespace whittle::io
