#include "ply/ply_header.hh"

#include "bytes/text_cursor.hh"
#include "format/mesh_builder.hh"

namespace whittle::io {

namespace {

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, std::string_view name) : bytes_(bytes), cursor_(bytes, name) {}

  PlyHeader read() {
    if (cursor_.token() != "ply") cursor_.fail("not a PLY file: it doesn't begin with \"ply\"");
    const bool lone_returns = ends_with_lone_return();
    cursor_.next_line();
    while (true) {
      if (cursor_.at_end()) cursor_.fail("the header has no end_header; the file is truncated");
      cursor_.skip_blanks();
      const char* const start = cursor_.position();
      const std::string_view keyword = cursor_.token();
      if (keyword == "end_header") break;
      read_line(start, keyword);
      cursor_.next_line();
    }
    finish(lone_returns);
    return std::move(header_);
  }

 private:
  void read_line(const char* start, std::string_view keyword) {
    if (keyword.empty()) return;
    if (keyword == "comment" || keyword == "obj_info") {
      cursor_.skip_rest_of_line();
      header_.remarks.emplace_back(start, static_cast<std::size_t>(cursor_.position() - start));
      return;
    }
    cursor_.skip_blanks();
    if (keyword == "format") {
      read_format();
    } else if (keyword == "element") {
      read_element();
    } else if (keyword == "property") {
      if (header_.elements.empty()) cursor_.fail(start, "a property before any element");
      read_property();
    } else {
      cursor_.fail(start, "unknown word \"" + cursor_.excerpt(start) + "\" in the header");
    }
  }

  void read_format() {
    const char* const at = cursor_.position();
    const std::string_view format = cursor_.token();
    if (format == "ascii") {
      header_.encoding = PlyEncoding::ascii;
    } else if (format == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (format == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else {
      cursor_.fail(at, "unknown format \"" + cursor_.excerpt(at) + '"');
    }
    has_format_ = true;
  }

  void read_element() {
    PlyElement element;
    element.name = cursor_.token();
    for (const PlyElement& other : header_.elements) {
      if (other.name == element.name) cursor_.fail("element " + element.name + " is declared twice");
    }
    cursor_.skip_blanks();
    const char* const at = cursor_.position();
    const std::string what = "the number of " + element.name + " elements";
    const std::int64_t count = cursor_.whole_integer(what);
    if (count < 0) cursor_.fail(at, what + " is negative");
    element.count = static_cast<std::uint64_t>(count);
    if ((element.name == "vertex" || element.name == "face") && element.count > most_elements) {
      cursor_.fail(at, what + " is " + std::to_string(count) + ", more than the " + std::to_string(most_elements) +
                           " a mesh can have");
    }
    header_.elements.push_back(std::move(element));
  }

  void read_property() {
    PlyProperty property;
    TextCursor ahead = cursor_;
    if (ahead.token() == "list") {
      cursor_ = ahead;
      cursor_.skip_blanks();
      property.count_type = read_type();
      cursor_.skip_blanks();
    }
    property.type = read_type();
    cursor_.skip_blanks();
    property.name = cursor_.token();
    if (property.name.empty()) cursor_.fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType read_type() {
    struct Named {
      std::string_view name;
      PlyType type;
    };
    static constexpr Named types[] = {
        {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
        {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
        {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
        {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
        {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
        {"float64", PlyType::float64}};
    const char* const at = cursor_.position();
    const std::string_view token = cursor_.token();
    for (const auto& [name, type] : types) {
      if (token == name) return type;
    }
    cursor_.fail_token(at, "a property type");
  }

  bool ends_with_lone_return() const {
    const auto at = static_cast<std::size_t>(cursor_.position() - bytes_.data());
    return at < bytes_.size() && bytes_[at] == '\r' && (at + 1 == bytes_.size() || bytes_[at + 1] != '\n');
  }

  // Where lines end with CR alone, an LF after end_header belongs to the data.
  void finish(bool lone_returns) {
    if (!has_format_) cursor_.fail("the header has no format line");
    cursor_.skip_rest_of_line();
    header_.data_start = static_cast<std::size_t>(cursor_.position() - bytes_.data());
    if (lone_returns && !cursor_.at_end()) {
      ++header_.data_start;
    } else {
      cursor_.next_line();
      header_.data_start = static_cast<std::size_t>(cursor_.position() - bytes_.data());
    }
  }

  std::string_view bytes_;
  TextCursor cursor_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, std::string_view name) { return HeaderReader(bytes, name).read(); }

}  // namespace whittle::io
