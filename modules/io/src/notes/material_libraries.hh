#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "whittle/io/file_notes.hh"

namespace whittle::io {

/// The material libraries that a file names, relative to its folder unless absolute. One may come several times.
std::vector<std::filesystem::path> material_libraries(const FileNotes& notes);

/// The content of a file; nothing if it can't be read.
std::optional<std::string> text_of(const std::filesystem::path& path);

}  // namespace whittle::io
