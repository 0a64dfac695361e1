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
  /// Colours as real numbers, which lose nothing, instead of 8 bits, which every program reads. For formats that have
  /// both. PLY has the type that the notes say, too.
  bool exact_colors = false;
  /// Default: by the name's extension.
  std::optional<Format> format{};
  /// Whether to pack with gzip. Default: by the name's extension, `.gz`; a stream is not packed.
  std::optional<bool> gzip{};
  /// Those of the file that the mesh was read from (`ReadResult::notes`).
  FileNotes notes{};
};

struct WriteResult {
  /// One line each, without a full stop: what the mesh has and the file can't hold.
  std::vector<std::string> warnings;
};

/// Writes a mesh, with all attributes that the format has. Where it stores them at vertices, a vertex with several
/// wedges is written several times, at the same position: reading welds it. Positions are exact, but for binary STL,
/// which rounds them to 32 bits, and warns where that takes more than a millionth of the diagonal from what the file
/// that was read has. The file appears complete or not at all (`OutputFile`). \throw std::invalid_argument if the
/// extension stands for no supported format (`format_of`). \throw WriteError if the file can't be written, or if the
/// format can't hold a coordinate (binary STL).
WriteResult write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options = {});

/// Likewise to a stream that was opened in binary mode. `options.format` is ignored.
/// \throw WriteError with the name "output" if the stream fails.
WriteResult write_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options = {});

}  // namespace whittle::io
