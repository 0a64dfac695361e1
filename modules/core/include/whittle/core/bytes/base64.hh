#pragma once

#include <optional>
#include <string>
#include <string_view>

// RFC 4648, section 4.

namespace whittle {

/// Bytes as text, padded with '='.
std::string base64(std::string_view bytes);
/// The bytes of base64 text; padding may be missing. Empty if it isn't base64.
std::optional<std::string> decode_base64(std::string_view text);

}  // namespace whittle
