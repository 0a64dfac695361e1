#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace whittle::io {

/// The supported mesh file formats.
enum class Format { obj, off, ply, stl };

namespace detail {

/// A format's row (src/format/format_row.hh). Each format defines its row among its own sources.
struct FormatRow;
extern const FormatRow obj_row;
extern const FormatRow off_row;
extern const FormatRow ply_row;
extern const FormatRow stl_row;

/// The table of formats, in the order of `Format`. All knowledge about formats comes from this table.
inline constexpr std::array format_table{&obj_row, &off_row, &ply_row, &stl_row};

}  // namespace detail

inline constexpr auto all_formats = [] {
  std::array<Format, detail::format_table.size()> formats{};
  for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = static_cast<Format>(i);
  return formats;
}();

/// "obj": the name in `--format` and JSON reports. Also an extension of the format's files.
std::string_view name_of(Format format);

/// {"obj"}: the extensions of the format's files, lower case, without the dot.
std::span<const std::string_view> extensions_of(Format format);

/// "OBJ": for sentences.
std::string_view title_of(Format format);

/// Whether the format has a text and a binary form, chosen by `WriteOptions::ascii`. The others have one form.
bool has_text_and_binary(Format format);

/// "obj, off, ply, stl": the names of all formats.
std::string format_names(std::string_view separator = ", ");

/// "OBJ, OFF, PLY or STL": the titles of all formats, for sentences.
std::string format_titles();

/// "PLY or STL": the titles of the formats that `has_text_and_binary`.
std::string titles_with_text_and_binary();

/// Whether a file name ends in ".gz", in upper or lower case: the file is compressed with gzip.
bool has_gzip_extension(const std::filesystem::path& path);

/// The format of a file name's extension, in upper or lower case; in "mesh.ply.gz" of the one before ".gz".
/// \throw std::invalid_argument without an extension of a supported format. The message gives a remedy, and names known
///        but unsupported formats (glTF, 3DS, OpenMesh's OM, archives…). It doesn't repeat the path.
Format format_of(const std::filesystem::path& path);

/// The format of an extension, with or without its dot: "ply", ".PLY".
/// \throw std::invalid_argument as `format_of`.
Format format_from_extension(std::string_view extension);

}  // namespace whittle::io
