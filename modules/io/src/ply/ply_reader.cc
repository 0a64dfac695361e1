// Stanford PLY (G. Turk, "The PLY Polygon File Format", 1994). Elements and properties come in any order; vertices,
// faces and tristrips are used. One reader serves text and binary: it takes numbers from a source, which knows the
// encoding.
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "format/mesh_builder.hh"
#include "ply/ply.hh"
#include "ply/ply_fixed_rows.hh"
#include "ply/ply_header.hh"
#include "ply/ply_notes.hh"
#include "ply/ply_plan.hh"
#include "ply/ply_sources.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle::io {

namespace {

using Row = std::array<double, other + 1>;

template <class Source>
class BodyReader {
 public:
  BodyReader(const PlyHeader& header, const Source& source, const ReadOptions& options)
      : header_(header), source_(source), threads_(options.threads), scope_(options.attributes) {
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
    ReadResult result = builder_.finish();
    if (scope_ == AttributeScope::all) take_ply_notes(header_, result);
    return result;
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

  void read_vertices(const PlyElement& element) {
    PlyVertexPlan plan = plan_vertices(element, scope_);
    if (element.count > 0 && !(plan.has[x] && plan.has[y] && plan.has[z])) {
      source_.fail(source_.location(), "vertices need the properties x, y and z; the header lacks one");
    }
    if (!plan.lost.empty()) builder_.warn("vertex properties not carried: " + plan.lost);
    const auto count = static_cast<std::size_t>(element.count);
    if (element.properties.empty()) return;
    resize_large(builder_.positions(), count);
    if (plan.normals) resize_large(builder_.normals(), count);
    if (plan.colors) resize_large(builder_.colors(), count);
    if (plan.has[tolerance]) resize_large(builder_.tolerances(), count);
    auto& attributes = builder_.mesh().attributes;
    attributes = std::move(plan.others.attributes);
    for (Attribute& attribute : attributes) resize_large(attribute.values, attribute.n_components * count);
    const std::vector<PlyTarget> targets = targets_of(plan.others, attributes);
    if constexpr (Source::has_fixed_sizes) {
      if (read_fixed_vertices(element, plan, targets)) return;
    }
    for (std::size_t v = 0; v < count; ++v) read_vertex(source_, element, plan, targets, v);
  }

  void read_vertex(Source& source, const PlyElement& element, const PlyVertexPlan& plan,
                   const std::vector<PlyTarget>& targets, std::size_t v) {
    Row row{};
    source.begin_row();
    for (std::size_t p = 0; p < plan.roles.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      const PlyRole role = plan.roles[p];
      if (property.count_type) {
        skip_property(source, element, property);
        continue;
      }
      const Location at = source.location();
      row[role] = source.number(property.type, "a vertex property");
      if (role <= z && !std::isfinite(row[role])) source.fail(at, "a coordinate is not finite");
      if (role == other && targets[p].values != nullptr) targets[p].set(v, row[role]);
    }
    source.end_row();
    builder_.positions()[v] = {row[x], row[y], row[z]};
    if (plan.normals) {
      builder_.normals()[v] = {static_cast<float>(row[nx]), static_cast<float>(row[ny]), static_cast<float>(row[nz])};
    }
    if (plan.colors) builder_.colors()[v] = color_of(plan, row);
    if (plan.has[tolerance]) builder_.tolerances()[v] = row[tolerance];
  }

  static Color color_of(const PlyVertexPlan& plan, const Row& row) {
    Color color;
    for (std::size_t i = 0; i < 4; ++i) color[i] = static_cast<float>(row[red + i] / plan.color_units[i]);
    if (!plan.has[alpha]) color[3] = opaque;
    return color;
  }

  // On all threads, if every row has the same size and all is well. Returns false if not: then nothing was read, and
  // whoever reads one row after the other finds the first error.
  bool read_fixed_vertices(const PlyElement& element, const PlyVertexPlan& plan,
                           const std::vector<PlyTarget>& targets) {
    std::size_t size = 0;
    for (const PlyProperty& property : element.properties) {
      if (property.count_type) return false;
      size += size_of(property.type);
    }
    const auto count = static_cast<std::size_t>(element.count);
    const PlyRows rows = source_.rows(size);
    std::atomic<bool> are_finite = true;
    for_each_range(count, threads_, [&](std::size_t begin, std::size_t end) {
      if (!read_vertex_rows(rows, element, plan, targets, begin, end, builder_)) are_finite = false;
    });
    if (!are_finite) return false;
    source_.skip_bytes(count * size);
    return true;
  }

  // Warns of lost properties.
  PlyFacePlan plan_of(const PlyElement& element, AttributeScope scope) {
    PlyFacePlan plan = plan_faces(element, scope);
    if (element.count > 0 && !plan.corners) {
      source_.fail(source_.location(), "elements \"" + element.name + "\" have no list vertex_indices");
    }
    if (!plan.lost.empty() && element.count > 0) {
      builder_.warn(element.name + " properties not carried: " + plan.lost);
    }
    return plan;
  }

  void read_faces(const PlyElement& element) {
    PlyFacePlan plan = plan_of(element, scope_);
    auto& attributes = builder_.mesh().face_attributes;
    attributes = std::move(plan.others.attributes);
    for (Attribute& attribute : attributes) attribute.values.resize(attribute.n_components * builder_.face_count());
    if (plan.texcoords) builder_.corner_texcoords().type = element.properties[*plan.texcoords].type;
    if constexpr (Source::has_fixed_sizes) {
      if (read_fixed_triangles(element, plan)) return;
    }
    builder_.reserve_faces(static_cast<std::size_t>(element.count));
    std::vector<double> row(element.properties.size());
    for (std::uint64_t f = 0; f < element.count; ++f) {
      const Location at = read_face(element, plan, row);
      const std::size_t n_before = builder_.face_count();
      add_face(at, plan.texcoords.has_value());
      add_face_values(plan, row, builder_.face_count() - n_before);
    }
  }

  // Reads the corners of a face, their texture coordinates, and its other numbers. Returns where it begins.
  Location read_face(const PlyElement& element, const PlyFacePlan& plan, std::vector<double>& row) {
    source_.begin_row();
    const Location at = source_.location();
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (p == plan.corners) {
        const std::uint64_t length = read_length(source_, *property.count_type, property.name);
        corners_.clear();
        for (std::uint64_t c = 0; c < length; ++c) corners_.push_back(read_corner(source_, property.type));
      } else if (p == plan.texcoords) {
        const std::uint64_t length = read_length(source_, *property.count_type, property.name);
        texcoords_.clear();
        for (std::uint64_t i = 0; i < length; ++i) {
          texcoords_.push_back(source_.list_number(property.type, "a texture coordinate"));
        }
      } else if (plan.others.places[p]) {
        row[p] = source_.list_number(property.type, "a face property");
      } else {
        skip_property(source_, element, property);
      }
    }
    source_.end_row();
    return at;
  }

  // A face without texture has no texture coordinates.
  void add_face(Location at, bool may_have_texcoords) {
    if (!may_have_texcoords || texcoords_.empty()) {
      builder_.add_polygon(corners_);
      return;
    }
    if (texcoords_.size() != 2 * corners_.size()) {
      source_.fail(at, "a list texcoord of length " + std::to_string(texcoords_.size()) + " for a face of " +
                           std::to_string(corners_.size()) + " corners; it needs two numbers a corner");
    }
    std::vector<double>& values = builder_.corner_texcoords().values;
    items_.clear();
    for (std::size_t c = 0; c < corners_.size(); ++c) {
      if (values.size() / 2 >= most_elements) source_.fail(at, "more texture coordinates than a mesh can have");
      items_.push_back({.texcoord = static_cast<Index>(values.size() / 2)});
      values.push_back(texcoords_[2 * c]);
      values.push_back(texcoords_[2 * c + 1]);
    }
    builder_.add_polygon(corners_, items_);
  }

  // \param n_added the triangles that the face became
  void add_face_values(const PlyFacePlan& plan, const std::vector<double>& row, std::size_t n_added) {
    auto& attributes = builder_.mesh().face_attributes;
    if (attributes.empty()) return;
    const std::size_t n_before = builder_.face_count() - n_added;
    for (Attribute& attribute : attributes) attribute.values.resize(attribute.n_components * builder_.face_count());
    const std::vector<PlyTarget> targets = targets_of(plan.others, attributes);
    for (std::size_t p = 0; p < row.size(); ++p) {
      for (std::size_t i = 0; i < n_added && targets[p].values != nullptr; ++i) targets[p].set(n_before + i, row[p]);
    }
  }

  // Like `read_fixed_vertices`, if all faces are triangles, and all or none have texture coordinates.
  bool read_fixed_triangles(const PlyElement& element, const PlyFacePlan& plan) {
    std::size_t size = 0;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.count_type && p != plan.corners && p != plan.texcoords) return false;
      const std::size_t n = p == plan.corners ? 3 : p == plan.texcoords ? 6 : 1;
      size += (property.count_type ? size_of(*property.count_type) : 0) + n * size_of(property.type);
    }
    const auto count = static_cast<std::size_t>(element.count);
    if (count == 0 || count > source_.bytes_left() / size) return false;
    if (plan.texcoords && count > most_elements / 3) return false;
    PlyTriangles read;
    resize_large(read.faces, count);
    if (plan.texcoords) resize_large(read.texcoords, 6 * count);
    auto& attributes = builder_.mesh().face_attributes;
    for (Attribute& attribute : attributes) {
      attribute.values.resize(attribute.n_components * (builder_.face_count() + count));
    }
    std::vector<PlyTarget> targets = targets_of(plan.others, attributes);
    for (PlyTarget& target : targets) {
      if (target.values != nullptr) target.values += builder_.face_count() * target.stride;
    }
    std::atomic<bool> are_triangles = true;
    const PlyRows rows = source_.rows(size);
    for_each_range(count, threads_, [&](std::size_t begin, std::size_t end) {
      if (!read_triangle_rows(rows, element, plan, targets, vertices_, begin, end, read)) are_triangles = false;
    });
    if (!are_triangles) {
      for (Attribute& attribute : attributes) attribute.values.resize(attribute.n_components * builder_.face_count());
      return false;
    }
    source_.skip_bytes(count * size);
    add_fixed_triangles(std::move(read));
    return true;
  }

  void add_fixed_triangles(PlyTriangles read) {
    if (!read.texcoords.empty()) {
      std::vector<CornerItems>& items = builder_.corner_items();
      items.resize(3 * builder_.face_count());
      reserve_large(items, items.size() + 3 * read.faces.size());
      for (Index i = 0; i < 3 * read.faces.size(); ++i) items.push_back({.texcoord = i});
      builder_.corner_texcoords().values = std::move(read.texcoords);
    }
    builder_.add_triangles(std::move(read.faces));
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
    const PlyFacePlan plan = plan_of(element, AttributeScope::per_vertex);
    for (std::uint64_t s = 0; s < element.count; ++s) {
      source_.begin_row();
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        if (p == plan.corners) {
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
  AttributeScope scope_;
  MeshBuilder builder_;
  std::uint64_t vertices_ = 0;
  // Of the face being read.
  std::vector<Index> corners_;
  std::vector<double> texcoords_;
  std::vector<CornerItems> items_;
};

}  // namespace

ReadResult read_ply(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  const std::string_view text = without_byte_order_mark(bytes);
  PlyHeader header = read_ply_header(text, name);
  for (PlyElement& element : header.elements) {
    if (element.name == "vertex") lower_known_names(element.properties);
  }
  if (header.encoding == PlyEncoding::ascii) {
    TextCursor cursor(text, name);
    cursor.skip_to(header.data_start);
    return BodyReader(header, PlyTextSource(cursor), options).read();
  }
  const std::endian order = header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little;
  return BodyReader(header, PlyBinarySource(ByteCursor(text, header.data_start, order, name)), options).read();
}

}  // namespace whittle::io
