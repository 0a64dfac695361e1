#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/file_notes.hh"
#include "whittle/io/format.hh"

namespace whittle::io {

struct WriteOptions {
  /// Text instead of binary, in formats that have both.
  bool ascii = false;
  /// Colours as real numbers, without loss, instead of 8 bits, which every program reads. For formats that have both.
  /// PLY also has the type in the notes.
  bool exact_colors = false;
  /// Default: by the name's extension.
  std::optional<Format> format{};
  /// Whether to compress with gzip. Default: by the name's extension, `.gz`; a stream is not compressed.
  std::optional<bool> gzip{};
  /// Notes of the file that the mesh was read from (`ReadResult::notes`).
  FileNotes notes{};
};

struct WriteResult {
  /// One line each, without a full stop: content of the mesh that the file can't hold.
  std::vector<std::string> warnings;
};

/// Writes a mesh, with all attributes that the format has. If the format stores them at vertices, a vertex with several
/// wedges is written several times, at the same position: reading welds it. Positions are exact, except in binary STL,
/// which rounds to 32 bits, with a warning if that moves positions of the input by more than a millionth of the
/// diagonal. The file appears complete or not at all (`OutputFile`).
/// \throw std::invalid_argument if the extension's format isn't supported (`format_of`)
/// \throw WriteError if the file can't be written, or if the format can't hold a coordinate (binary STL)
WriteResult write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options = {});

/// The same to a stream opened in binary mode. `options.format` is ignored.
/// \throw WriteError with the name "output" if the stream fails.
WriteResult write_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options = {});

}  // namespace whittle::io
