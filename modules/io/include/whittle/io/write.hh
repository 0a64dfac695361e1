#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

#include "whittle/engine/indexed_mesh.hh"
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

/// Writes a mesh: positions exactly (PLY with 64-bit coordinates as soon as 32 bits would lose something; STL rounds
/// to 32 bits, as the format has it), normals and colours where the format has them.
/// Goes to a temporary file beside `path` that is renamed when complete, so neither a failure nor a reader ever meets a
/// half-written file; a symbolic link is followed; a device or pipe is written directly.
/// \throw std::invalid_argument if the ending names no format that is written (`format_of`).
/// \throw WriteError if the file can't be written.
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh, const WriteOptions& options = {});

/// Likewise to a stream opened in binary mode; `options.format` is ignored.
/// \throw WriteError with the name "output" when the stream fails.
void write_mesh(std::ostream& out, Format format, const IndexedMesh& mesh, const WriteOptions& options = {});

}  // namespace whittle::io
