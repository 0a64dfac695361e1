#pragma once

#include <string>
#include <vector>

#include "files/input.hh"

namespace whittle::app {

/// Reads several files as one mesh: their meshes one after the other, none joined to another. Each file is read, and
/// repaired, on its own. Vertices and faces are counted through all files. What not all files have (normals, colours,
/// attributes, materials' textures) is left out, with a warning. The face attribute "o" says which file a face is from.
/// \param paths not glTF
/// \throw io::ReadError as `read_input`
/// \throw UnsupportedMesh for materials or textures that one file can't name: those of two folders, or of one name in
/// different libraries; if the vertices or faces are too many
Input read_joined(const std::vector<std::string>& paths, const FileOptions& options, unsigned threads, const Talk& talk,
                  io::AttributeScope attributes);

}  // namespace whittle::app
