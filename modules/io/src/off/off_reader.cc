// Geomview's OFF ("Object File Format", Geomview manual, section 4.2.5): [ST][C][N]OFF [BINARY], then a line per vertex
// and a line per face. Other dimensions than three (4OFF, nOFF) are refused. Binary files come in dialects, see
// `BinaryLayout`.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bytes/byte_cursor.hh"
#include "bytes/text_cursor.hh"
#include "format/mesh_builder.hh"
#include "off/off.hh"

namespace whittle::io {

namespace {

struct OffHeader {
  bool normals = false;
  bool colors = false;
  bool texcoords = false;
  bool binary = false;
};

struct OffCounts {
  std::int64_t vertices = 0;
  std::int64_t faces = 0;
};

// The keyword may be missing. Then the file begins with its counts.
OffHeader read_header(TextCursor& cursor) {
  OffHeader header;
  cursor.skip_space('#');
  const char* const start = cursor.position();
  if (cursor.at_end()) cursor.fail("the file holds nothing but comments");
  TextCursor after = cursor;
  const std::string_view keyword = after.token();
  std::string_view prefix = keyword;
  if (!prefix.ends_with("OFF")) {
    if (keyword.find_first_not_of("+-0123456789") == std::string_view::npos) return header;
    cursor.fail(start, "not an OFF file: it doesn't begin with OFF");
  }
  cursor = after;
  prefix.remove_suffix(3);
  while (!prefix.empty()) {
    if (prefix.starts_with("ST")) {
      header.texcoords = true;
      prefix.remove_prefix(2);
      continue;
    }
    if (prefix.front() == '4' || prefix.front() == 'n') {
      cursor.fail(start, '"' + std::string(keyword) + "\": only three-dimensional OFF is read");
    }
    if (prefix.front() != 'C' && prefix.front() != 'N') {
      cursor.fail(start, "not an OFF file: unknown keyword \"" + cursor.excerpt(start) + '"');
    }
    (prefix.front() == 'C' ? header.colors : header.normals) = true;
    prefix.remove_prefix(1);
  }
  cursor.skip_blanks();
  TextCursor ahead = cursor;
  if (ahead.token() == "BINARY") {
    header.binary = true;
    cursor = ahead;
  }
  return header;
}

void warn_of_what_is_not_carried(MeshBuilder& builder, const OffHeader& header, bool face_colors, bool extra_values) {
  if (header.texcoords && builder.mesh().attributes.empty()) builder.warn("texture coordinates are not carried");
  if (face_colors) builder.warn("face colours are not carried");
  if (extra_values) builder.warn("numbers after a vertex's coordinates are ignored: the keyword OFF announces none");
}

/// \return where texture coordinates of vertices go
std::vector<double>* add_texcoords(MeshBuilder& builder) {
  builder.mesh().attributes.push_back(
      {.name = "s,t", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}});
  return &builder.mesh().attributes.back().values;
}

/// \param cursor where the file goes on
template <class Cursor>
[[noreturn]] void fail_for_wrong_counts(const Cursor& cursor, std::int64_t n_faces) {
  cursor.fail("the file goes on after the " + std::to_string(n_faces) + " faces it announces; its counts are wrong");
}

class AsciiOffReader {
 public:
  AsciiOffReader(const TextCursor& cursor, const OffHeader& header, AttributeScope scope)
      : cursor_(cursor), header_(header) {
    if (header.texcoords && scope == AttributeScope::all) texcoords_ = add_texcoords(builder_);
  }

  ReadResult read() {
    read_counts();
    builder_.reserve_vertices(static_cast<std::size_t>(counts_.vertices));
    builder_.reserve_faces(static_cast<std::size_t>(counts_.faces));
    for (std::int64_t v = 0; v < counts_.vertices; ++v) read_vertex();
    for (std::int64_t f = 0; f < counts_.faces; ++f) read_face();
    cursor_.skip_space('#');
    if (!cursor_.at_end()) fail_for_wrong_counts(cursor_, counts_.faces);
    warn_of_what_is_not_carried(builder_, header_, face_colors_, extra_values_);
    if (color_numbers_) builder_.warn("colours given by number are not carried");
    return builder_.finish();
  }

 private:
  bool more_on_line() {
    cursor_.skip_blanks();
    return !cursor_.at_line_end() && cursor_.peek() != '#';
  }

  // The shortest vertex is "0 0 0", the shortest face "0". Each has a line break, but for the last.
  void read_counts() {
    counts_.vertices = read_count("the number of vertices");
    counts_.faces = read_count("the number of faces");
    if (more_on_line()) cursor_.whole_integer("the number of edges");
    const auto left = static_cast<std::int64_t>(cursor_.bytes_left()) + 1;
    if (counts_.vertices > left / 6 || counts_.faces > (left - 6 * counts_.vertices) / 2) {
      cursor_.fail("the file is too short for " + std::to_string(counts_.vertices) + " vertices and " +
                   std::to_string(counts_.faces) + " faces; it is truncated or its counts are wrong");
    }
  }

  std::int64_t read_count(std::string_view what) {
    cursor_.skip_space('#');
    const char* const at = cursor_.position();
    const std::int64_t count = cursor_.whole_integer(what);
    if (count < 0) cursor_.fail(at, std::string(what) + " is negative");
    if (static_cast<std::uint64_t>(count) > most_elements) {
      cursor_.fail(at, std::string(what) + " is " + std::to_string(count) + ", more than the " +
                           std::to_string(most_elements) + " a mesh can have");
    }
    return count;
  }

  void read_vertex() {
    cursor_.skip_space('#');
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      cursor_.skip_blanks();
      position[i] = cursor_.finite_number<double>("a coordinate");
    }
    builder_.positions().push_back(position);
    if (header_.normals) {
      auto& normal = builder_.normals().emplace_back();
      for (float& component : normal) {
        cursor_.skip_blanks();
        component = cursor_.number<float>("a normal");
      }
    }
    if (header_.colors || header_.texcoords) {
      read_color();
    } else if (more_on_line()) {
      extra_values_ = true;
    }
    cursor_.next_line();
  }

  // A colour has one to four numbers, texture coordinates two.
  void read_color() {
    std::array<float, 6> values{};
    std::size_t count = 0;
    while (more_on_line()) {
      if (count == values.size()) cursor_.fail("too many numbers for a vertex");
      values[count++] = cursor_.number<float>("a colour");
    }
    const std::size_t components = header_.texcoords && count >= 2 ? count - 2 : header_.texcoords ? 0 : count;
    if (texcoords_ != nullptr) {
      const bool has_both = count >= 2;
      for (std::size_t i = 0; i < 2; ++i) texcoords_->push_back(has_both ? double{values[components + i]} : 0);
    }
    if (!header_.colors) {
      if (components > 0) extra_values_ = true;
      return;
    }
    Color color{opaque, opaque, opaque, opaque};
    if (components == 3 || components == 4) {
      for (std::size_t i = 0; i < components; ++i) color[i] = values[i];
    } else if (components > 4) {
      cursor_.fail("too many numbers for a vertex");
    } else {
      color_numbers_ = true;
    }
    builder_.colors().push_back(color);
  }

  void read_face() {
    cursor_.skip_space('#');
    const char* const start = cursor_.position();
    const std::int64_t corners = cursor_.whole_integer("a face's number of corners");
    if (corners < 1 || static_cast<std::uint64_t>(corners) > (cursor_.bytes_left() + 1) / 2) {
      cursor_.fail(start, "a face of " + std::to_string(corners) + " corners; the file is truncated or invalid");
    }
    corners_.clear();
    for (std::int64_t c = 0; c < corners; ++c) {
      cursor_.skip_blanks();
      corners_.push_back(read_corner());
    }
    builder_.add_polygon(corners_);
    face_colors_ = more_on_line() || face_colors_;
    cursor_.next_line();
  }

  Index read_corner() {
    const char* const at = cursor_.position();
    const std::int64_t vertex = cursor_.whole_integer("a vertex number");
    if (vertex < 0 || vertex >= counts_.vertices) {
      cursor_.fail(at, "vertex number " + std::to_string(vertex) + ", but the file has " +
                           std::to_string(counts_.vertices) + " vertices, counted from 0");
    }
    return static_cast<Index>(vertex);
  }

  TextCursor cursor_;
  OffHeader header_;
  OffCounts counts_;
  MeshBuilder builder_;
  std::vector<double>* texcoords_ = nullptr;  // Null: not to be carried.
  std::vector<Index> corners_;
  bool face_colors_ = false;
  bool extra_values_ = false;
  bool color_numbers_ = false;
};

// Geomview writes big endian, four real colour components per vertex, and a face colour: the number of its components,
// then the components. OpenMesh writes little endian, three colour components (integers or reals), and no face colour.
// Other programs mix these.
struct BinaryLayout {
  std::endian order = std::endian::big;
  std::size_t color_components = 4;
  bool face_colors = true;
};

class BinaryOffReader {
 public:
  BinaryOffReader(const ByteCursor& cursor, const OffHeader& header, const BinaryLayout& layout, AttributeScope scope)
      : cursor_(cursor), header_(header), layout_(layout) {
    cursor_.set_order(layout.order);
    if (header.texcoords && scope == AttributeScope::all) texcoords_ = add_texcoords(builder_);
  }

  /// Whether the file ends exactly after its last face if it has this layout.
  static bool fits(ByteCursor cursor, const OffHeader& header, const BinaryLayout& layout) {
    BinaryOffReader reader(cursor, header, layout, AttributeScope::per_vertex);
    try {
      reader.read_counts();
      reader.cursor_.skip(static_cast<std::size_t>(reader.counts_.vertices) * reader.vertex_bytes());
      for (std::int64_t f = 0; f < reader.counts_.faces; ++f) {
        reader.cursor_.skip(static_cast<std::size_t>(reader.read_corner_count()) * sizeof(std::int32_t));
        reader.skip_face_color();
      }
    } catch (const ReadError&) {
      return false;
    }
    return reader.cursor_.bytes_left() == 0;
  }

  ReadResult read() {
    read_counts();
    builder_.reserve_vertices(static_cast<std::size_t>(counts_.vertices));
    builder_.reserve_faces(static_cast<std::size_t>(counts_.faces));
    for (std::int64_t v = 0; v < counts_.vertices; ++v) read_vertex();
    for (std::int64_t f = 0; f < counts_.faces; ++f) read_face();
    if (cursor_.bytes_left() > 0) fail_for_wrong_counts(cursor_, counts_.faces);
    warn_of_what_is_not_carried(builder_, header_, face_colors_, false);
    return builder_.finish();
  }

 private:
  std::size_t vertex_bytes() const {
    const std::size_t numbers = 3 + (header_.normals ? 3U : 0U) + (header_.colors ? layout_.color_components : 0U) +
                                (header_.texcoords ? 2U : 0U);
    return numbers * sizeof(float);
  }

  void read_counts() {
    const std::size_t start = cursor_.offset();
    counts_.vertices = cursor_.read<std::int32_t>("the number of vertices");
    counts_.faces = cursor_.read<std::int32_t>("the number of faces");
    cursor_.read<std::int32_t>("the number of edges");
    const std::int64_t smallest_face = sizeof(std::int32_t) * (layout_.face_colors ? 2 : 1);
    const auto left = static_cast<std::int64_t>(cursor_.bytes_left());
    const auto vertex_size = static_cast<std::int64_t>(vertex_bytes());
    if (counts_.vertices < 0 || counts_.faces < 0 || counts_.vertices > left / vertex_size ||
        counts_.faces > (left - counts_.vertices * vertex_size) / smallest_face) {
      cursor_.fail(start, "the file is too short for " + std::to_string(counts_.vertices) + " vertices and " +
                              std::to_string(counts_.faces) + " faces; it is truncated or its counts are wrong");
    }
  }

  void read_vertex() {
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      const std::size_t at = cursor_.offset();
      position[i] = cursor_.read<float>("a coordinate");
      if (!std::isfinite(position[i])) cursor_.fail(at, "a coordinate is not finite");
    }
    builder_.positions().push_back(position);
    if (header_.normals) {
      for (float& component : builder_.normals().emplace_back()) component = cursor_.read<float>("a normal");
    }
    if (header_.colors) {
      Color color{0, 0, 0, opaque};
      for (std::size_t i = 0; i < layout_.color_components; ++i) color[i] = read_color_component();
      builder_.colors().push_back(color);
    }
    for (std::size_t i = 0; i < 2 && header_.texcoords; ++i) {
      const double texcoord = cursor_.read<float>("a texture coordinate");
      if (texcoords_ != nullptr) texcoords_->push_back(texcoord);
    }
  }

  // A component is an integer up to 255 or a real number. The bits of a real number, taken as an integer, exceed 255.
  float read_color_component() {
    const auto bits = cursor_.read<std::uint32_t>("a colour");
    return bits <= 255 ? static_cast<float>(bits) : std::bit_cast<float>(bits);
  }

  std::int32_t read_corner_count() {
    const std::size_t start = cursor_.offset();
    const auto corners = cursor_.read<std::int32_t>("a face's number of corners");
    if (corners < 1 || static_cast<std::size_t>(corners) > cursor_.bytes_left() / sizeof(std::int32_t)) {
      cursor_.fail(start, "a face of " + std::to_string(corners) + " corners; the file is truncated or invalid");
    }
    return corners;
  }

  void read_face() {
    const std::int32_t corners = read_corner_count();
    corners_.clear();
    for (std::int32_t c = 0; c < corners; ++c) {
      const std::size_t at = cursor_.offset();
      const auto vertex = cursor_.read<std::int32_t>("a vertex number");
      if (vertex < 0 || vertex >= counts_.vertices) {
        cursor_.fail(at, "vertex number " + std::to_string(vertex) + ", but the file has " +
                             std::to_string(counts_.vertices) + " vertices, counted from 0");
      }
      corners_.push_back(static_cast<Index>(vertex));
    }
    builder_.add_polygon(corners_);
    skip_face_color();
  }

  void skip_face_color() {
    if (!layout_.face_colors) return;
    const std::size_t at = cursor_.offset();
    const auto components = cursor_.read<std::int32_t>("a face's number of colour components");
    if (components < 0 || components > 4) {
      cursor_.fail(at, std::to_string(components) + " colour components; the file is invalid");
    }
    cursor_.require(static_cast<std::size_t>(components) * sizeof(float), "a face's colour");
    cursor_.skip(static_cast<std::size_t>(components) * sizeof(float));
    face_colors_ = face_colors_ || components > 0;
  }

  ByteCursor cursor_;
  OffHeader header_;
  BinaryLayout layout_;
  OffCounts counts_;
  MeshBuilder builder_;
  std::vector<double>* texcoords_ = nullptr;  // Null: not to be carried.
  std::vector<Index> corners_;
  bool face_colors_ = false;
};

// The layout that fits the file's length. If none does, the likelier of the two unmixed ones: reading then fails with
// the better message.
BinaryLayout find_layout(ByteCursor cursor, const OffHeader& header) {
  for (const std::endian order : {std::endian::big, std::endian::little}) {
    for (const std::size_t components : {4U, 3U}) {
      for (const bool face_colors : {true, false}) {
        const BinaryLayout layout{order, components, face_colors};
        if (BinaryOffReader::fits(cursor, header, layout)) return layout;
      }
    }
  }
  constexpr BinaryLayout geomview{std::endian::big, 4, true};
  constexpr BinaryLayout open_mesh{std::endian::little, 3, false};
  cursor.require(sizeof(std::uint32_t), "the number of vertices");
  const auto vertices_if_big = load<std::uint32_t>(cursor.here(), std::endian::big);
  const auto vertices_if_little = load<std::uint32_t>(cursor.here(), std::endian::little);
  return vertices_if_big <= vertices_if_little ? geomview : open_mesh;
}

}  // namespace

ReadResult read_off(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  const std::string_view text = without_byte_order_mark(bytes);
  TextCursor cursor(text, name);
  const OffHeader header = read_header(cursor);
  if (!header.binary) return AsciiOffReader(cursor, header, options.attributes).read();
  cursor.next_line();
  const auto start = static_cast<std::size_t>(cursor.position() - bytes.data());
  const ByteCursor data(bytes, start, std::endian::big, name);
  return BinaryOffReader(data, header, find_layout(data, header), options.attributes).read();
}

}  // namespace whittle::io
