#pragma once

#include <string>
#include <string_view>

#include "whittle/io/read.hh"

namespace whittle::io {

// One reader a format: the whole file in memory, and its name for messages. They triangulate polygons and leave the
// other repairs to `repair`. All throw ReadError.
ReadResult read_obj(std::string_view text, std::string_view name);
ReadResult read_off(std::string_view bytes, std::string_view name);
ReadResult read_ply(std::string_view bytes, std::string_view name);
ReadResult read_stl(std::string_view bytes, std::string_view name);

/// Refuses what is evidently not `format`: empty files, other mesh formats, archives, UTF-16, web pages, binary data
/// where text should be. Files that might be right pass. \throw ReadError
void refuse_foreign_content(std::string_view bytes, std::string_view name, Format format);

/// The file is as long as an STL file with the number of facets in its header: it is one, whatever it starts with.
bool is_binary_stl_by_size(std::string_view bytes);

/// Text without the byte order mark some editors put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

}  // namespace whittle::io
