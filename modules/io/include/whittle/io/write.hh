#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/format.hh"

namespace whittle::io {

struct WriteOptions {
  /// Text instead of binary for PLY and STL. OBJ and OFF are always text. Default false.
  bool ascii = false;
  /// Colours in PLY and OFF as real numbers, which loses nothing, instead of the 8 bits every program reads.
  /// OBJ colours are always real numbers; STL has none. Default false.
  bool exact_colors = false;
  /// What to write. Default: by the name's ending.
  std::optional<Format> format{};
};

struct WriteResult {
  /// One line each, without a full stop: what the mesh has and the file doesn't (STL rounds, has no normals…).
  std::vector<std::string> warnings;
};

/// Writes a mesh: positions exactly (PLY with 64-bit coordinates as soon as 32 bits would lose something; only binary
/// STL, which has 32 bits, rounds them), normals and colours where the format has them.
/// Goes to a temporary file beside `path` that is renamed when complete (`OutputFile`).
/// \throw std::invalid_argument if the ending names no format that is written (`format_of`).
/// \throw WriteError if the file can't be written, or a coordinate is too large for binary STL.
WriteResult write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options = {});

/// Likewise to a stream opened in binary mode; `options.format` is ignored.
/// \throw WriteError with the name "output" when the stream fails.
WriteResult write_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options = {});

}  // namespace whittle::io
