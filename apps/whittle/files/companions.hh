#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/output.hh"
#include "terminal/talk.hh"

// Files that a mesh file needs beside it: material libraries, textures.

namespace whittle::app {

/// That of a file.
std::filesystem::path folder_of(const std::filesystem::path& file);

/// Whether a path that a file in some folder names leads to that folder, or to one below it.
bool is_inside(const std::filesystem::path& name);

/// Writes a file of any name, with the folders that it needs, unless it is among the files already.
void write_with_folders(OutputFiles& files, const std::filesystem::path& path, const std::string& bytes);

/// Copies files beside an output, as they lie beside the input; none that is there is overwritten. Says in a line what
/// was copied, and in a warning what couldn't be. Nothing is done for standard streams, and within one folder.
/// \param names of the files, relative to the input's folder. Absolute ones are left alone
void copy_companions(OutputFiles& files, const std::string& input, const std::string& output,
                     std::span<const std::filesystem::path> names, const Talk& talk,
                     std::vector<std::string>& warnings);

}  // namespace whittle::app
