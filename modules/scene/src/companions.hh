#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "whittle/scene/format.hh"

// Files that a mesh file needs beside it: material libraries, textures.

namespace whittle {

/// Whether a path that a file in some folder names leads to that folder, or to one below it.
bool is_inside(const std::filesystem::path& name);

/// Copies files beside the input to the output; existing files aren't overwritten. Notes copied files, and warns of
/// failures. Does nothing for standard streams, and within one folder.
/// \param names of the files, relative to the input's folder. Absolute ones are ignored
void copy_companions(io::OutputFiles& files, const std::string& input, const std::string& output,
                     std::span<const std::filesystem::path> names, SceneMessages& messages);

}  // namespace whittle
