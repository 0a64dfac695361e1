#pragma once

#include <filesystem>
#include <string_view>

namespace whittle::io {

/// The path that a name in UTF-8 stands for. (On Windows, `std::filesystem::path` takes a `std::string` for text in the
/// encoding of the system.) Text that isn't UTF-8 is in that encoding.
std::filesystem::path path_of(std::string_view name);

}  // namespace whittle::io
