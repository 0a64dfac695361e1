#pragma once

#include <string_view>

#include "whittle/io/format.hh"

namespace whittle::io {

/// Refuses content that is evidently not of this format: an empty file, another mesh format, an archive, UTF-16, a web
/// page, binary data where text should be. Content that might be right passes. \throw ReadError
void refuse_wrong_content(std::string_view bytes, std::string_view name, Format format);

}  // namespace whittle::io
