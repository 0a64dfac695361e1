#include "bytes/text_cursor.hh"
#include "format/format_row.hh"
#include "ply/ply.hh"

namespace whittle::io::detail {

namespace {

constexpr std::string_view ply_extensions[] = {"ply"};

Evidence recognise_ply(std::string_view bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  return text.starts_with("ply\n") || text.starts_with("ply\r") ? Evidence::likely : Evidence::none;
}

}  // namespace

constinit const FormatRow ply_row{
    .format = Format::ply,
    .name = "ply",
    .title = "PLY",
    .extensions = ply_extensions,
    .beginning = Beginning::text_header,
    .has_text_and_binary = true,
    .names_libraries = true,
    .names_textures = true,
    .recognises = recognise_ply,
    .read = read_ply,
    .write = write_ply,
};

}  // namespace whittle::io::detail
