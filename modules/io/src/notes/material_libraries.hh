#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "whittle/io/file_notes.hh"

namespace whittle::io {

/// The material libraries that a file names, relative to its folder unless absolute. One may come several times.
std::vector<std::filesystem::path> material_libraries(const FileNotes& notes);

}  // namespace whittle::io
