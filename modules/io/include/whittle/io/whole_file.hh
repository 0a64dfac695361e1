#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace whittle::io {

/// Opens a file to read its bytes. \param what its name in messages \throw ReadError, also for a folder
std::ifstream open_file(const std::filesystem::path& path, const std::string& what);

/// The bytes of a file. \param what its name in messages \throw ReadError
std::string read_file(const std::filesystem::path& path, const std::string& what);

/// The same; empty if the file can't be read.
std::optional<std::string> content_of(const std::filesystem::path& path);

}  // namespace whittle::io
