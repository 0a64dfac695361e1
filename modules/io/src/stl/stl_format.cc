#include "bytes/text_cursor.hh"
#include "format/format_row.hh"
#include "stl/stl.hh"

namespace whittle::io::detail {

namespace {

constexpr std::string_view stl_extensions[] = {"stl"};

bool starts_with_word(std::string_view text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  return text.size() == word.size() || static_cast<unsigned char>(text[word.size()]) <= ' ';
}

Evidence recognise_stl(std::string_view bytes) {
  if (is_binary_stl_by_size(bytes)) return Evidence::certain;
  const std::string_view text = without_byte_order_mark(bytes);
  const bool has_facet = text.substr(0, 1024).find("facet") != std::string_view::npos;
  return starts_with_word(text, "solid") && has_facet ? Evidence::likely : Evidence::none;
}

}  // namespace

constinit const FormatRow stl_row{
    .format = Format::stl,
    .name = "stl",
    .title = "STL",
    .extensions = stl_extensions,
    .beginning = Beginning::any_bytes,  // a binary file's count may be wrong: the reader says so
    .has_text_and_binary = true,
    .names_libraries = false,
    .names_textures = false,
    .recognises = recognise_stl,
    .read = read_stl,
    .write = write_stl,
};

}  // namespace whittle::io::detail
