// STL (3D Systems, "StereoLithography Interface Specification", 1988), ASCII and binary (little endian). Every facet
// has three corners of its own; `weld_borders` joins them. Facet normals are ignored: they follow from the corners.
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "bytes/byte_cursor.hh"
#include "bytes/text_cursor.hh"
#include "format/mesh_builder.hh"
#include "stl/stl.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle::io {

namespace {

constexpr std::size_t prefix_bytes = stl_header_bytes + sizeof(std::uint32_t);
constexpr std::size_t facet_bytes = 50;  // 12 floats (normal and corners) and 2 attribute bytes

bool equals_ignoring_case(std::string_view text, std::string_view lower) {
  return text.size() == lower.size() && std::equal(text.begin(), text.end(), lower.begin(), [](char a, char b) {
           return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
         });
}

void add_facet(MeshBuilder& builder, const std::array<Vec3, 3>& corners) {
  auto& positions = builder.positions();
  const auto first = static_cast<Index>(positions.size());
  positions.insert(positions.end(), corners.begin(), corners.end());
  builder.add_triangle({first, first + 1, first + 2});
}

void check_facet_count(std::uint64_t facets, std::string_view name) {
  if (facets * 3 <= most_elements) return;
  throw ReadError(std::string(name), std::to_string(facets) + " facets have more corners than the " +
                                         std::to_string(most_elements) + " vertices a mesh can have");
}

void lower(std::atomic<std::size_t>& least, std::size_t value) {
  for (std::size_t seen = least; value < seen && !least.compare_exchange_weak(seen, value);) {
  }
}

ReadResult read_binary(std::string_view bytes, std::string_view name, unsigned threads) {
  ByteCursor cursor(bytes, 0, std::endian::little, name);
  cursor.require(prefix_bytes, "the header and the number of facets");
  cursor.skip(stl_header_bytes);
  const auto facets = cursor.read<std::uint32_t>("the number of facets");
  check_facet_count(facets, name);
  if (cursor.bytes_left() < facets * std::uint64_t{facet_bytes}) {
    cursor.fail(stl_header_bytes, "the file is too short for " + std::to_string(facets) + " facets, there are " +
                                      std::to_string(cursor.bytes_left() / facet_bytes) +
                                      "; it is truncated or its count is wrong");
  }
  if (cursor.bytes_left() - facets * std::size_t{facet_bytes} >= facet_bytes) {
    cursor.fail(stl_header_bytes, "the file goes on after the " + std::to_string(facets) + " facets it announces, to " +
                                      std::to_string(cursor.bytes_left() / facet_bytes) + "; its count is wrong");
  }

  MeshBuilder builder;
  resize_large(builder.positions(), std::size_t{facets} * 3);
  std::vector<Triangle> faces;
  resize_large(faces, facets);
  std::atomic<std::size_t> first_bad = bytes.size();  // byte of the first coordinate that is not finite
  std::atomic<bool> has_attributes = false;
  for_each_range(facets, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const std::size_t offset = cursor.offset() + f * facet_bytes;
      const char* const facet = bytes.data() + offset;
      for (std::size_t i = 0; i < 9; ++i) {
        const std::size_t at = (3 + i) * sizeof(float);
        const auto value = load<float>(facet + at, std::endian::little);
        if (!std::isfinite(value)) lower(first_bad, offset + at);
        builder.positions()[3 * f + i / 3][static_cast<Eigen::Index>(i % 3)] = value;
      }
      const auto corner = static_cast<Index>(3 * f);
      faces[f] = {corner, corner + 1, corner + 2};
      if (facet[facet_bytes - 1] != 0 || facet[facet_bytes - 2] != 0) {
        has_attributes.store(true, std::memory_order_relaxed);
      }
    }
  });
  if (first_bad < bytes.size()) cursor.fail(first_bad, "a coordinate is not finite");
  builder.add_triangles(std::move(faces));
  cursor.skip(std::size_t{facets} * facet_bytes);
  if (has_attributes) builder.warn("attribute bytes (often facet colours) are not carried");
  if (cursor.bytes_left() > 0) {
    builder.warn(std::to_string(cursor.bytes_left()) + " bytes after the last facet are ignored");
  }
  return builder.finish();
}

class AsciiStlReader {
 public:
  AsciiStlReader(std::string_view text, std::string_view name) : cursor_(text, name), name_(name) {
    // A facet takes seven lines, about 250 bytes. A wrong guess costs a reallocation.
    builder_.reserve_vertices(text.size() / 250 * 3);
    builder_.reserve_faces(text.size() / 250);
  }

  ReadResult read() {
    std::size_t solids = 0;
    for (cursor_.skip_space(); !cursor_.at_end(); cursor_.skip_space()) {
      read_solid();
      ++solids;
    }
    check_facet_count(builder_.vertex_count() / 3, name_);
    if (solids > 1) builder_.warn("the names of " + std::to_string(solids) + " solids are not carried");
    return builder_.finish();
  }

 private:
  bool skip_word_if(std::string_view word) {
    cursor_.skip_space();
    TextCursor ahead = cursor_;
    if (!equals_ignoring_case(ahead.token(), word)) return false;
    cursor_ = ahead;
    return true;
  }

  void expect(std::string_view word) {
    if (!skip_word_if(word)) cursor_.fail_token(cursor_.position(), '"' + std::string(word) + '"');
  }

  void read_solid() {
    expect("solid");
    cursor_.skip_rest_of_line();  // The name of the solid.
    while (skip_word_if("facet")) read_facet();
    if (!skip_word_if("endsolid")) cursor_.fail_token(cursor_.position(), "\"facet\" or \"endsolid\"");
    cursor_.skip_rest_of_line();
  }

  // The normal's line is skipped unread: programs write nan and worse for facets without area.
  void read_facet() {
    cursor_.skip_rest_of_line();
    expect("outer");
    expect("loop");
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      expect("vertex");
      for (int i = 0; i < 3; ++i) {
        cursor_.skip_blanks();
        corner[i] = cursor_.finite_number<double>("a coordinate");
      }
    }
    expect("endloop");
    expect("endfacet");
    add_facet(builder_, corners);
  }

  TextCursor cursor_;
  std::string_view name_;
  MeshBuilder builder_;
};

// Many binary files begin with "solid", too.
bool looks_like_text(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, 1024);
  return start.find('\0') == std::string_view::npos;
}

}  // namespace

bool is_binary_stl_by_size(std::string_view bytes) {
  if (bytes.size() < prefix_bytes) return false;
  const std::uint64_t facets = load<std::uint32_t>(bytes.data() + stl_header_bytes, std::endian::little);
  return facets > 0 && bytes.size() == prefix_bytes + facets * facet_bytes;
}

ReadResult read_stl(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  if (is_binary_stl_by_size(bytes)) return read_binary(bytes, name, options.threads);
  const std::string_view text = without_byte_order_mark(bytes);
  TextCursor cursor(text, name);
  cursor.skip_space();
  if (equals_ignoring_case(cursor.token(), "solid") && looks_like_text(text)) return AsciiStlReader(text, name).read();
  return read_binary(bytes, name, options.threads);
}

}  // namespace whittle::io
