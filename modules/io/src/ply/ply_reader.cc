// Stanford PLY (G. Turk, "The PLY Polygon File Format", 1994). Elements and properties come in any order; those of
// vertices, faces and tristrips are used. One reader serves text and binary: it takes numbers from a source, which
// knows the encoding.
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "format/mesh_builder.hh"
#include "ply/ply.hh"
#include "ply/ply_header.hh"
#include "ply/ply_sources.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle::io {

namespace {

// The meaning of a vertex property, and the index of its number in `Row`.
enum Role : std::size_t { x, y, z, nx, ny, nz, red, green, blue, alpha, tolerance, other };
using Row = std::array<double, other + 1>;

Role role_of(std::string_view property) {
  struct Named {
    std::string_view name;
    Role role;
  };
  static constexpr Named names[] = {{"x", x},
                                    {"y", y},
                                    {"z", z},
                                    {"nx", nx},
                                    {"ny", ny},
                                    {"nz", nz},
                                    {"red", red},
                                    {"r", red},
                                    {"diffuse_red", red},
                                    {"green", green},
                                    {"g", green},
                                    {"diffuse_green", green},
                                    {"blue", blue},
                                    {"b", blue},
                                    {"diffuse_blue", blue},
                                    {"alpha", alpha},
                                    {"a", alpha},
                                    {"diffuse_alpha", alpha},
                                    {"tolerance", tolerance}};
  for (const auto& [name, role] : names) {
    if (property == name) return role;
  }
  return other;
}

// The number that means full intensity. Integers of 8 and 16 bits use their full range. `MeshBuilder` scales all others
// when the whole file is known.
double color_scale(PlyType type) {
  if (type == PlyType::uint8 || type == PlyType::int8) return 255;
  if (type == PlyType::uint16 || type == PlyType::int16) return 65535;
  return 1;
}

template <class Source>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, const Source& source, unsigned threads)
      : header_(header), source_(source), threads_(threads) {
    for (const PlyElement& element : header.elements) {
      if (element.name == "vertex") vertices_ = element.count;
    }
  }

  ReadResult read() {
    for (const PlyElement& element : header_.elements) {
      check_count(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        skip_element(element);
      }
    }
    source_.finish();
    return builder_.finish();
  }

 private:
  using Location = typename Source::Location;

  // Checks the file's length before anything is allocated for the elements.
  void check_count(const PlyElement& element) {
    std::uint64_t least = 0;
    for (const PlyProperty& property : element.properties) least += Source::least_bytes(property);
    if (least > 0 && element.count > source_.bytes_left() / least) {
      source_.fail(source_.location(), "the file is too short for " + std::to_string(element.count) + " elements \"" +
                                           element.name + "\"; it is truncated or its header is wrong");
    }
  }

  static void skip_property(Source& source, const PlyElement& element, const PlyProperty& property) {
    if (!property.count_type) {
      source.skip(property.type, 1, element.name);
    } else {
      source.skip(property.type, read_length(source, *property.count_type, property.name), element.name);
    }
  }

  static std::uint64_t read_length(Source& source, PlyType type, const std::string& list) {
    const Location at = source.location();
    const std::int64_t length = source.length(type, "the length of a list");
    if (length < 0 || static_cast<std::uint64_t>(length) > source.bytes_left()) {
      source.fail(at, "a list " + list + " of length " + std::to_string(length) + "; the file is truncated or invalid");
    }
    return static_cast<std::uint64_t>(length);
  }

  void skip_element(const PlyElement& element) {
    if (element.count == 0 || element.properties.empty()) return;
    builder_.warn("elements \"" + element.name + "\" are not carried");
    for (std::uint64_t i = 0; i < element.count; ++i) {
      source_.begin_row();
      for (const PlyProperty& property : element.properties) skip_property(source_, element, property);
      source_.end_row();
    }
  }

  struct VertexPlan {
    std::vector<Role> roles;  // Of each property.
    std::array<bool, other + 1> has{};
    bool normals = false;
    bool colors = false;
    std::array<double, 4> color_scales{1, 1, 1, 1};
  };

  VertexPlan plan_vertices(const PlyElement& element) {
    VertexPlan plan;
    for (const PlyProperty& property : element.properties) {
      const Role role = property.count_type ? other : role_of(property.name);
      plan.roles.push_back(role);
      plan.has[role] = true;
      if (role >= red && role <= alpha) plan.color_scales[role - red] = color_scale(property.type);
    }
    if (element.count > 0 && !(plan.has[x] && plan.has[y] && plan.has[z])) {
      source_.fail(source_.location(), "vertices need the properties x, y and z; the header lacks one");
    }
    plan.normals = plan.has[nx] && plan.has[ny] && plan.has[nz];
    plan.colors = plan.has[red] && plan.has[green] && plan.has[blue];
    std::string lost;
    for (std::size_t i = 0; i < plan.roles.size(); ++i) {
      const Role role = plan.roles[i];
      const bool carried = role <= z || (role <= nz && plan.normals) || (role <= alpha && role >= red && plan.colors);
      if (!carried) lost += (lost.empty() ? "" : ", ") + element.properties[i].name;
    }
    if (!lost.empty()) builder_.warn("vertex properties not carried: " + lost);
    return plan;
  }

  void read_vertices(const PlyElement& element) {
    const VertexPlan plan = plan_vertices(element);
    const auto count = static_cast<std::size_t>(element.count);
    if (element.properties.empty()) return;
    resize_large(builder_.positions(), count);
    if (plan.normals) resize_large(builder_.normals(), count);
    if (plan.colors) resize_large(builder_.colors(), count);
    if (plan.has[tolerance]) resize_large(builder_.tolerances(), count);
    if constexpr (Source::has_fixed_sizes) {
      if (read_fixed_vertices(element, plan)) return;
    }
    for (std::size_t v = 0; v < count; ++v) read_vertex(source_, element, plan, v);
  }

  void read_vertex(Source& source, const PlyElement& element, const VertexPlan& plan, std::size_t v) {
    Row row{};
    source.begin_row();
    for (std::size_t p = 0; p < plan.roles.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const Role role = plan.roles[p];
      if (property.count_type) {
        skip_property(source, element, property);
        continue;
      }
      const Location at = source.location();
      row[role] = source.number(property.type, "a vertex property");
      if (role <= z && !std::isfinite(row[role])) source.fail(at, "a coordinate is not finite");
    }
    source.end_row();
    builder_.positions()[v] = {row[x], row[y], row[z]};
    if (plan.normals) {
      builder_.normals()[v] = {static_cast<float>(row[nx]), static_cast<float>(row[ny]), static_cast<float>(row[nz])};
    }
    if (plan.colors) builder_.colors()[v] = color_of(plan, row);
    if (plan.has[tolerance]) builder_.tolerances()[v] = row[tolerance];
  }

  static Color color_of(const VertexPlan& plan, const Row& row) {
    Color color;
    for (std::size_t i = 0; i < 4; ++i) color[i] = static_cast<float>(row[red + i] / plan.color_scales[i]);
    if (!plan.has[alpha]) color[3] = opaque;
    return color;
  }

  // On all threads, if every row has the same size and all is well. Returns false if not: then nothing was read, and
  // whoever reads one row after the other finds the first error.
  bool read_fixed_vertices(const PlyElement& element, const VertexPlan& plan) {
    std::size_t size = 0;
    for (const PlyProperty& property : element.properties) {
      if (property.count_type) return false;
      size += size_of(property.type);
    }
    const auto count = static_cast<std::size_t>(element.count);
    try {
      for_each_range(count, threads_, [&](std::size_t begin, std::size_t end) {
        Source source = source_.further(begin * size);
        for (std::size_t v = begin; v < end; ++v) read_vertex(source, element, plan, v);
      });
    } catch (const ReadError&) {
      return false;
    }
    source_.skip_bytes(count * size);
    return true;
  }

  // The index of the property that holds the corners. Warns of the other properties.
  std::size_t find_corners(const PlyElement& element) {
    std::size_t found = element.properties.size();
    std::string lost;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index")) {
        found = p;
      } else {
        lost += (lost.empty() ? "" : ", ") + property.name;
      }
    }
    if (element.count > 0 && found == element.properties.size()) {
      source_.fail(source_.location(), "elements \"" + element.name + "\" have no list vertex_indices");
    }
    if (!lost.empty() && element.count > 0) builder_.warn(element.name + " properties not carried: " + lost);
    return found;
  }

  void read_faces(const PlyElement& element) {
    const std::size_t list = find_corners(element);
    if constexpr (Source::has_fixed_sizes) {
      if (read_fixed_triangles(element, list)) return;
    }
    builder_.reserve_faces(static_cast<std::size_t>(element.count));
    for (std::uint64_t f = 0; f < element.count; ++f) {
      source_.begin_row();
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p != list) {
          skip_property(source_, element, element.properties[p]);
          continue;
        }
        const PlyProperty& property = element.properties[p];
        const std::uint64_t length = read_length(source_, *property.count_type, property.name);
        if (length == 3) {
          builder_.add_triangle(read_triangle(source_, property.type));
          continue;
        }
        corners_.clear();
        for (std::uint64_t c = 0; c < length; ++c) corners_.push_back(read_corner(source_, property.type));
        builder_.add_polygon(corners_);
      }
      source_.end_row();
    }
  }

  // As `read_fixed_vertices`, if all faces are triangles.
  bool read_fixed_triangles(const PlyElement& element, std::size_t list) {
    std::size_t size = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.count_type && p != list) return false;
      size += property.count_type ? size_of(*property.count_type) + 3 * size_of(property.type) : size_of(property.type);
    }
    const auto count = static_cast<std::size_t>(element.count);
    if (count == 0 || count > source_.bytes_left() / size) return false;
    std::vector<Triangle> faces;
    resize_large(faces, count);
    std::atomic<bool> are_triangles = true;
    try {
      for_each_range(count, threads_, [&](std::size_t begin, std::size_t end) {
        Source source = source_.further(begin * size);
        for (std::size_t f = begin; f < end && are_triangles.load(std::memory_order_relaxed); ++f) {
          for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (p != list) {
              skip_property(source, element, property);
            } else if (source.length(*property.count_type, "the length of a list") == 3) {
              faces[f] = read_triangle(source, property.type);
            } else {
              are_triangles = false;
              return;
            }
          }
        }
      });
    } catch (const ReadError&) {
      return false;
    }
    if (!are_triangles) return false;
    source_.skip_bytes(count * size);
    builder_.add_triangles(std::move(faces));
    return true;
  }

  Triangle read_triangle(Source& source, PlyType type) const {
    const Index a = read_corner(source, type);
    const Index b = read_corner(source, type);
    return {a, b, read_corner(source, type)};
  }

  Index read_corner(Source& source, PlyType type) const {
    const Location at = source.location();
    const std::int64_t vertex = source.entry(type, "a vertex number");
    if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices_) fail_vertex_number(at, vertex);
    return static_cast<Index>(vertex);
  }

  [[noreturn]] void fail_vertex_number(Location at, std::int64_t vertex) const {
    source_.fail(at, "vertex number " + std::to_string(vertex) + ", but the file has " + std::to_string(vertices_) +
                         " vertices, counted from 0");
  }

  // Every three consecutive vertices of a strip are a triangle; every second triangle is turned over. −1 begins a new
  // strip. A triangle with two equal corners joins two strips and is no face.
  void read_strips(const PlyElement& element) {
    const std::size_t list = find_corners(element);
    for (std::uint64_t s = 0; s < element.count; ++s) {
      source_.begin_row();
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p == list) {
          read_strip(element.properties[p]);
        } else {
          skip_property(source_, element, element.properties[p]);
        }
      }
      source_.end_row();
    }
  }

  void read_strip(const PlyProperty& property) {
    const std::int64_t restart_if_unsigned =
        property.type == PlyType::uint32 ? std::int64_t{std::numeric_limits<std::uint32_t>::max()} : -1;
    const std::uint64_t length = read_length(source_, *property.count_type, property.name);
    std::size_t in_strip = 0;
    Index a = 0;
    Index b = 0;
    for (std::uint64_t i = 0; i < length; ++i) {
      const Location at = source_.location();
      const std::int64_t vertex = source_.entry(property.type, "a vertex number");
      if (vertex == -1 || vertex == restart_if_unsigned) {
        in_strip = 0;
        continue;
      }
      if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertices_) fail_vertex_number(at, vertex);
      const auto c = static_cast<Index>(vertex);
      if (in_strip >= 2 && a != b && b != c && a != c) {
        builder_.add_triangle(in_strip % 2 == 0 ? Triangle{a, b, c} : Triangle{b, a, c});
      }
      ++in_strip;
      a = b;
      b = c;
    }
  }

  const PlyHeader& header_;
  Source source_;
  unsigned threads_;
  MeshBuilder builder_;
  std::uint64_t vertices_ = 0;
  std::vector<Index> corners_;
};

}  // namespace

ReadResult read_ply(std::string_view bytes, std::string_view name, unsigned threads) {
  const std::string_view text = without_byte_order_mark(bytes);
  const PlyHeader header = read_ply_header(text, name);
  if (header.encoding == PlyEncoding::ascii) {
    TextCursor cursor(text, name);
    cursor.skip_to(header.data_start);
    return BodyReader(header, PlyTextSource(cursor), threads).read();
  }
  const std::endian order = header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little;
  return BodyReader(header, PlyBinarySource(ByteCursor(text, header.data_start, order, name)), threads).read();
}

}  // namespace whittle::io
