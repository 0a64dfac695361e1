#include "document/uri.hh"

#include "whittle/core/bytes/base64.hh"
#include "whittle/io/path_of.hh"

namespace whittle::gltf {
namespace {

std::optional<int> hexadecimal(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return {};
}

/// Invalid escapes are kept.
std::string unescaped(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto high = uri[i] == '%' && i + 2 < uri.size() ? hexadecimal(uri[i + 1]) : std::nullopt;
    const auto low = high ? hexadecimal(uri[i + 2]) : std::nullopt;
    if (low) {
      text += static_cast<char>(*high * 16 + *low);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

bool is_plain_in_uri(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("-._~").find(c) != std::string_view::npos;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

std::optional<std::string> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) return {};
  return decode_base64(uri.substr(comma + 1));
}

std::string data_uri(std::string_view bytes) { return "data:application/octet-stream;base64," + base64(bytes); }

std::optional<std::filesystem::path> file_of_uri(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (uri.empty() || (colon != std::string_view::npos && colon < uri.find('/'))) return {};
  const std::string text = unescaped(uri);
  if (text.find('\0') != std::string::npos) return {};
  std::filesystem::path path = io::path_of(text);
  if (path.is_absolute() || !path.has_filename()) return {};
  return path;
}

std::string uri_of_file(std::string_view name) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri;
  for (const char c : name) {
    if (is_plain_in_uri(c) || c == '/') {
      uri += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      (uri += '%') += digits[byte >> 4U];
      uri += digits[byte & 15U];
    }
  }
  return uri;
}

}  // namespace whittle::gltf
