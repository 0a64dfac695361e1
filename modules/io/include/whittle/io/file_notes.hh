#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/io/format.hh"

namespace whittle::io {

/// What a file says beside its mesh. Readers fill it in (`ReadResult::notes`); a writer that is given it
/// (`WriteOptions::notes`) says the same again, as far as its format can. Notes stay valid when the mesh is simplified.
struct FileNotes {
  /// OBJ: what follows `mtllib`, as it stands. It may name several files, and names may have blanks.
  std::vector<std::string> material_libraries;
  /// PLY: the lines of the header (`comment`, `obj_info`) that name textures, as they stand.
  std::vector<std::string> header_lines;

  /// The names that the values of a face attribute stand for, by the attribute's name: value i has name i. OBJ has the
  /// attributes "o" (objects) and "g" (groups), and "s" (smoothing groups), whose values are numbers. Where all faces
  /// have the same value, there is no attribute, and this has one entry.
  std::map<std::string, std::vector<std::string>> face_names;

  /// PLY: the properties of vertices and faces, in the order of the file.
  std::vector<std::string> vertex_properties;
  std::vector<std::string> face_properties;
  /// Whether 32-bit numbers hold all positions (`fit_float32`). Then rounding to 32 bits takes nothing that the file
  /// has.
  bool has_float32_positions = false;
  /// PLY: the type of vertex colours. Others than `uint8`, `uint16` and `float32` are not kept.
  ScalarType color_type = ScalarType::uint8;
};

/// The notes without the libraries, or textures, that a file of this format can't name.
FileNotes notes_in(Format format, FileNotes notes);

/// The files that a mesh file needs: its textures, its material libraries (MTL), and the textures that these name.
/// Paths are relative to the mesh file's folder, but for absolute ones; backslashes separate folders, too. Each comes
/// once, in the order of the notes. A library that can't be read is listed, without its textures.
/// \param folder of the mesh file
std::vector<std::filesystem::path> referenced_files(const FileNotes& notes, const std::filesystem::path& folder);

}  // namespace whittle::io
