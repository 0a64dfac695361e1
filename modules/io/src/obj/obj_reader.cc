// Wavefront OBJ ("Object Files (.obj)", Wavefront Advanced Visualizer manual, appendix B1). Reads v, vn and f. Counts
// what is not carried, for warnings: texture coordinates, names, lines, free-form geometry.
#include <algorithm>
#include <array>
#include <compare>
#include <string>
#include <vector>

#include "bytes/text_cursor.hh"
#include "format/mesh_builder.hh"
#include "obj/obj.hh"

namespace whittle::io {

namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, std::string_view name) : cursor_(text, name), length_(text.size()) {}

  ReadResult read() {
    // A third of the lines are vertices, a line has about 30 bytes. A wrong guess costs a reallocation.
    builder_.reserve_vertices(length_ / 90);
    builder_.reserve_faces(length_ / 45);
    for (; !cursor_.at_end(); cursor_.next_line()) {
      cursor_.skip_blanks();
      if (!cursor_.at_line_end()) read_statement();
    }
    check_largest_vertex();
    check_counts();
    set_normals();
    warn_of_what_is_not_carried();
    return builder_.finish();
  }

 private:
  struct VertexNormal {
    Index vertex;
    Index normal;  // a number into `file_normals_`
    auto operator<=>(const VertexNormal&) const = default;
  };

  void read_statement();
  void read_vertex();
  void read_color(std::size_t vertex);
  void read_normal();
  void read_face();
  Index read_corner_vertex();
  void read_corner_rest(Index vertex);
  void note_corner_normal(Index vertex);
  void skip_other(std::string_view keyword);
  void check_largest_vertex() const;
  void check_counts() const;
  void set_normals();
  void warn_of_what_is_not_carried();

  TextCursor cursor_;
  std::size_t length_;
  MeshBuilder builder_;
  std::vector<Index> corners_;  // Of the face being read.

  // Faces may use vertices that come later. So the largest number is checked at the end.
  std::int64_t largest_vertex_ = -1;
  const char* largest_vertex_at_ = nullptr;

  std::vector<std::array<float, 3>> file_normals_;
  std::vector<Index> normal_of_vertex_;        // The first that a corner of the vertex has.
  std::vector<VertexNormal> further_normals_;  // Other ones, and those of vertices that come later.
  const char* bad_normal_at_ = nullptr;

  std::size_t texcoords_ = 0;
  std::size_t materials_ = 0;
  std::size_t groups_ = 0;
  std::size_t smoothing_groups_ = 0;
  std::size_t lines_and_points_ = 0;
  std::size_t free_form_ = 0;
  std::size_t unknown_ = 0;
  const char* first_unknown_ = nullptr;
};

void ObjReader::read_statement() {
  const char* const start = cursor_.position();
  if (cursor_.peek() == '#') return;
  const std::string_view keyword = cursor_.token();
  if (keyword == "v") {
    read_vertex();
  } else if (keyword == "f" || keyword == "fo") {
    read_face();
  } else if (keyword == "vn") {
    read_normal();
  } else if (keyword == "vt") {
    ++texcoords_;
  } else {
    const std::size_t unknown_before = unknown_;
    skip_other(keyword);
    if (unknown_ != unknown_before && first_unknown_ == nullptr) first_unknown_ = start;
  }
}

void ObjReader::skip_other(std::string_view keyword) {
  cursor_.skip_blanks();
  if (keyword == "usemtl" || keyword == "mtllib") {
    materials_ += keyword == "usemtl";
  } else if (keyword == "g" || keyword == "o") {
    ++groups_;
  } else if (keyword == "s") {
    const std::string_view group = cursor_.token();
    smoothing_groups_ += group != "off" && group != "0";
  } else if (keyword == "l" || keyword == "p") {
    ++lines_and_points_;
  } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
    ++free_form_;
  } else {
    static constexpr std::string_view harmless[] = {
        "vp",  "cstype", "deg", "bmat",  "step", "parm",       "trim",      "hole", "scrv",   "sp",
        "end", "con",    "mg",  "bevel", "lod",  "c_interp",   "d_interp",  "bsp",  "usemap", "maplib",
        "bzp", "cdc",    "cdp", "res",   "call", "shadow_obj", "trace_obj", "csh",  "ctech",  "stech"};
    for (const std::string_view known : harmless) {
      if (keyword == known) return;
    }
    ++unknown_;
  }
}

void ObjReader::read_vertex() {
  Vec3 position;
  for (int i = 0; i < 3; ++i) {
    cursor_.skip_blanks();
    position[i] = cursor_.finite_number<double>("a coordinate");
  }
  auto& positions = builder_.positions();
  positions.push_back(position);
  cursor_.skip_blanks();
  if (!cursor_.at_line_end() && cursor_.peek() != '#') read_color(positions.size() - 1);
}

// After x y z: nothing, w, or r g b [a]. Many programs write colours there, though the manual doesn't have them.
void ObjReader::read_color(std::size_t vertex) {
  std::array<float, 4> values{0, 0, 0, opaque};
  std::size_t count = 0;
  while (!cursor_.at_line_end() && cursor_.peek() != '#') {
    if (count == values.size()) cursor_.fail("a vertex has at most seven numbers");
    values[count++] = cursor_.number<float>("a colour");
    cursor_.skip_blanks();
  }
  if (count < 3) return;
  auto& colors = builder_.colors();
  colors.resize(vertex, Color{opaque, opaque, opaque, opaque});
  colors.push_back(values);
}

void ObjReader::read_normal() {
  std::array<float, 3> normal;
  for (float& component : normal) {
    cursor_.skip_blanks();
    component = cursor_.number<float>("a normal");
  }
  file_normals_.push_back(normal);
}

void ObjReader::read_face() {
  const char* const start = cursor_.position();
  corners_.clear();
  while (cursor_.skip_blanks(), !cursor_.at_line_end() && cursor_.peek() != '#') {
    const Index vertex = read_corner_vertex();
    if (!cursor_.at_token_end()) read_corner_rest(vertex);
    corners_.push_back(vertex);
  }
  if (corners_.size() < 3) {
    cursor_.fail(start, "a face needs three corners, this has " + std::to_string(corners_.size()) +
                            (cursor_.at_end() ? "; the file may be truncated" : ""));
  }
  builder_.add_polygon(corners_);
}

Index ObjReader::read_corner_vertex() {
  const char* const at = cursor_.position();
  const std::int64_t number = cursor_.integer("a vertex number");
  const auto vertices = static_cast<std::int64_t>(builder_.positions().size());
  const std::int64_t vertex = number > 0 ? number - 1 : vertices + number;
  if (number == 0) cursor_.fail(at, "vertex number 0; OBJ counts from 1");
  if (vertex < 0) {
    cursor_.fail(at, "vertex number " + std::to_string(number) + " reaches back before the first of the " +
                         std::to_string(vertices) + " vertices so far");
  }
  if (vertex > largest_vertex_) {
    largest_vertex_ = vertex;
    largest_vertex_at_ = at;
    if (static_cast<std::uint64_t>(vertex) >= most_elements) {
      cursor_.fail(at, "vertex number " + std::to_string(number) + " is more than the " +
                           std::to_string(most_elements) + " vertices a mesh can have");
    }
  }
  return static_cast<Index>(vertex);
}

// "/t", "//n" or "/t/n".
void ObjReader::read_corner_rest(Index vertex) {
  const char* const at = cursor_.position();
  if (!cursor_.skip_if('/')) cursor_.fail_token(at, "a vertex number");
  if (!cursor_.skip_if('/')) {
    if (cursor_.at_token_end()) return;  // "1/": some programs write it
    cursor_.integer("a texture coordinate number");
    if (cursor_.at_token_end()) return;
    if (!cursor_.skip_if('/')) cursor_.fail_token(at, "\"/\" and a normal number");
  }
  if (!cursor_.at_token_end()) note_corner_normal(vertex);
}

void ObjReader::note_corner_normal(Index vertex) {
  const char* const at = cursor_.position();
  const std::int64_t number = cursor_.whole_integer("a normal number");
  const auto normals = static_cast<std::int64_t>(file_normals_.size());
  const std::int64_t normal = number > 0 ? number - 1 : normals + number;
  if (number == 0 || normal < 0 || static_cast<std::uint64_t>(normal) >= most_elements) {
    if (bad_normal_at_ == nullptr) bad_normal_at_ = at;
    return;
  }
  const std::size_t vertices = builder_.positions().size();
  if (vertex < vertices && normal_of_vertex_.size() < vertices) normal_of_vertex_.resize(vertices, invalid_index);
  const Index value = static_cast<Index>(normal);
  if (vertex < vertices && normal_of_vertex_[vertex] == invalid_index) {
    normal_of_vertex_[vertex] = value;
  } else if (vertex >= vertices || normal_of_vertex_[vertex] != value) {
    further_normals_.push_back({vertex, value});
  }
}

void ObjReader::check_largest_vertex() const {
  const std::size_t vertices = builder_.vertex_count();
  if (largest_vertex_ < 0 || static_cast<std::uint64_t>(largest_vertex_) < vertices) return;
  cursor_.fail(largest_vertex_at_, "vertex number " + std::to_string(largest_vertex_ + 1) + ", but the file has " +
                                       std::to_string(vertices) + " vertices; it may be truncated");
}

void ObjReader::check_counts() const {
  if (builder_.vertex_count() > most_elements) {
    cursor_.fail("more than the " + std::to_string(most_elements) + " vertices a mesh can have");
  }
}

// A mesh has one normal per vertex. Where corners differ (at a crease), it is the mean of the different normals.
void ObjReader::set_normals() {
  if (normal_of_vertex_.empty() && further_normals_.empty() && bad_normal_at_ == nullptr) return;
  const std::size_t count = file_normals_.size();
  bool all_known = bad_normal_at_ == nullptr;
  for (const Index n : normal_of_vertex_) all_known = all_known && (n == invalid_index || n < count);
  for (const VertexNormal& further : further_normals_) all_known = all_known && further.normal < count;
  if (!all_known) {
    builder_.warn("normals are ignored: faces use numbers of normals that the file doesn't have");
    return;
  }
  const std::size_t vertices = builder_.vertex_count();
  auto& normals = builder_.normals();
  normals.assign(vertices, {0, 0, 0});
  normal_of_vertex_.resize(vertices, invalid_index);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (normal_of_vertex_[v] != invalid_index) normals[v] = file_normals_[normal_of_vertex_[v]];
  }
  std::sort(further_normals_.begin(), further_normals_.end());
  further_normals_.erase(std::unique(further_normals_.begin(), further_normals_.end()), further_normals_.end());
  bool averaged = false;
  for (const auto& [vertex, normal] : further_normals_) {
    Index& first = normal_of_vertex_[vertex];
    if (first == normal) continue;
    averaged = averaged || first != invalid_index;
    if (first == invalid_index) first = normal;
    for (std::size_t i = 0; i < 3; ++i) normals[vertex][i] += file_normals_[normal][i];
  }
  if (averaged) builder_.warn("normals that differ between the corners of a vertex were averaged");
}

void ObjReader::warn_of_what_is_not_carried() {
  auto& colors = builder_.colors();
  if (!colors.empty()) colors.resize(builder_.vertex_count(), Color{opaque, opaque, opaque, opaque});
  if (texcoords_ > 0) builder_.warn("texture coordinates (vt) are not carried");
  if (materials_ > 0) builder_.warn("materials (usemtl) are not carried");
  if (groups_ > 1) builder_.warn("groups and object names (g, o) are not carried");
  if (smoothing_groups_ > 0) builder_.warn("smoothing groups (s) are not carried");
  if (lines_and_points_ > 0) builder_.warn("lines and points (l, p) are not carried");
  if (free_form_ > 0) builder_.warn("free-form curves and surfaces (curv, surf) are not read");
  if (unknown_ > 0) {
    builder_.warn(std::to_string(unknown_) + " unknown statements ignored, the first in line " +
                  std::to_string(cursor_.line_of(first_unknown_)) + ": \"" + cursor_.excerpt(first_unknown_) + '"');
  }
}

}  // namespace

ReadResult read_obj(std::string_view bytes, std::string_view name, unsigned /*threads*/) {
  return ObjReader(without_byte_order_mark(bytes), name).read();
}

}  // namespace whittle::io
