#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace whittle::gltf {

bool is_data_uri(std::string_view uri);
/// The bytes of a data URI. Empty if it isn't in base64, or is no valid base64.
std::optional<std::string> decode_data_uri(std::string_view uri);
std::string data_uri(std::string_view bytes);

/// The file that a URI names, relative to the asset's folder. Empty if it names none there: it has a scheme, as http:
/// does, or is absolute.
std::optional<std::filesystem::path> file_of_uri(std::string_view uri);
/// Escapes characters that a URI can't contain. \param name with '/' between folders
std::string uri_of_file(std::string_view name);

}  // namespace whittle::gltf
