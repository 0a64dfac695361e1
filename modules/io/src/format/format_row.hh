#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/byte_sink.hh"
#include "whittle/io/read.hh"
#include "whittle/io/write.hh"

namespace whittle::io {

/// How surely a file's content shows its format.
enum class Evidence { none, likely, certain };

/// Possible beginnings of a format's files.
enum class Beginning {
  text,         ///< Text, and nothing but text follows.
  text_header,  ///< Text; binary data may follow.
  any_bytes,
};

namespace detail {

/// All that is known of a format. Adding a format means to write its row, and to list the row in
/// whittle/io/format.hh.
struct FormatRow {
  Format format;
  std::string_view name;                         ///< Lower case; also one of the extensions.
  std::string_view title;                        ///< In sentences.
  std::span<const std::string_view> extensions;  ///< Lower case, without the dot.
  Beginning beginning;

  /// Whether it is written as text or as binary data, by `WriteOptions::ascii`. If not, there is one way to write it.
  bool has_text_and_binary;

  bool names_libraries;  ///< Whether it has `FileNotes::material_libraries`.
  bool names_textures;   ///< Whether it has `FileNotes::header_lines`.

  /// Evidence that content has this format, regardless of the file's name. The surest format wins, of equally sure ones
  /// the first of the table. Null if the format's files have no common mark.
  Evidence (*recognises)(std::string_view bytes);

  /// Reads a whole file and triangulates its polygons (`MeshBuilder`); all other repairs are left to `repair`.
  /// \param name of the file, for messages. \throw ReadError
  ReadResult (*read)(std::string_view bytes, std::string_view name, const ReadOptions& options);

  /// \param warnings gets a line for each thing that the mesh has and the file can't hold.
  /// \throw std::range_error if the format can't hold a number of the mesh. The message doesn't name the file.
  void (*write)(ByteSink& sink, const IndexedMesh& mesh, const WriteOptions& options,
                std::vector<std::string>& warnings);
};

}  // namespace detail

/// \throw std::invalid_argument if there is no such format.
const detail::FormatRow& row_of(Format format);

}  // namespace whittle::io
