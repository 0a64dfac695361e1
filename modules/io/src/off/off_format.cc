#include "bytes/text_cursor.hh"
#include "format/format_row.hh"
#include "off/off.hh"

namespace whittle::io::detail {

namespace {

constexpr std::string_view off_extensions[] = {"off"};

// "OFF", "COFF", "STCNOFF BINARY"…
Evidence recognise_off(std::string_view bytes) {
  const std::string_view text = without_byte_order_mark(bytes);
  const std::string_view keyword = text.substr(0, text.find_first_of(" \t\r\n"));
  if (keyword.size() > 8 || !keyword.ends_with("OFF")) return Evidence::none;
  const std::string_view prefix = keyword.substr(0, keyword.size() - 3);
  return prefix.find_first_not_of("STCN4n") == std::string_view::npos ? Evidence::likely : Evidence::none;
}

}  // namespace

constinit const FormatRow off_row{
    .format = Format::off,
    .name = "off",
    .title = "OFF",
    .extensions = off_extensions,
    .beginning = Beginning::text_header,
    .has_text_and_binary = false,
    .names_libraries = false,
    .names_textures = false,
    .recognises = recognise_off,
    .read = read_off,
    .write = write_off,
};

}  // namespace whittle::io::detail
