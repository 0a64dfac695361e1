#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/io/format.hh"

namespace whittle::io {

/// Content of a file beside its mesh. Readers fill it in (`ReadResult::notes`); writers (`WriteOptions::notes`) write
/// it again, as far as their format can. Notes stay valid when the mesh is simplified.
struct FileNotes {
  /// OBJ: the text after `mtllib`, verbatim. It may name several files, and names may have blanks.
  std::vector<std::string> material_libraries;
  /// PLY: the lines of the header (`comment`, `obj_info`) that name textures, verbatim.
  std::vector<std::string> header_lines;

  /// Names of the values of face attributes, by attribute: value i has name i. OBJ has the attributes "o" (objects),
  /// "g" (groups) and "s" (smoothing groups, whose names are numbers). If all faces have the same value, the mesh has
  /// no attribute, and this has one entry.
  std::map<std::string, std::vector<std::string>> face_names;

  /// PLY: the properties of vertices and faces, in the order of the file.
  std::vector<std::string> vertex_properties;
  std::vector<std::string> face_properties;
  /// Whether 32-bit numbers represent all positions exactly (`fit_float32`).
  bool has_float32_positions = false;
  /// PLY: the type of vertex colours. Only `uint8`, `uint16` and `float32` are kept.
  ScalarType color_type = ScalarType::uint8;
};

/// The notes without the libraries, or textures, that a file of this format can't name.
FileNotes notes_in(Format format, FileNotes notes);

/// The files that a mesh file needs: its textures, its material libraries (MTL), and the libraries' textures. Paths are
/// relative to the mesh file's folder, or absolute; backslashes separate folders, too. Each file is listed once, in the
/// order of the notes. An unreadable library is listed without its textures.
/// \param folder of the mesh file
std::vector<std::filesystem::path> referenced_files(const FileNotes& notes, const std::filesystem::path& folder);

}  // namespace whittle::io
