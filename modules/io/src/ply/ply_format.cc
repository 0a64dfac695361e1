#include "bytes/text_cursor.hh"
#include "format/format_row.hh"
#include "ply/ply.hh"

namespace whittle::io::detail {

namespace {

constexpr std::string_view extensions[] = {"ply"};

Evidence recognise(std::string_view bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  return text.starts_with("ply\n") || text.starts_with("ply\r") ? Evidence::likely : Evidence::none;
}

}  // namespace

constinit const FormatRow ply_row{
    .format = Format::ply,
    .name = "ply",
    .title = "PLY",
    .extensions = extensions,
    .beginning = Beginning::text_header,
    .recognises = recognise,
    .read = read_ply,
    .write = write_ply,
};

}  // namespace whittle::io::detail
