#include "obj/obj_chunk.hh"

#include <algorithm>
#include <charconv>
#include <string>

namespace whittle::io {

ObjOthers& ObjOthers::operator+=(const ObjOthers& more) {
  materials += more.materials;
  groups += more.groups;
  smoothing_groups += more.smoothing_groups;
  lines_and_points += more.lines_and_points;
  free_form += more.free_form;
  unknown += more.unknown;
  if (first_unknown == nullptr) first_unknown = more.first_unknown;
  if (more.cut_face != nullptr) cut_face = more.cut_face;
  return *this;
}

ObjRows ObjChunk::guess_rows(std::string_view lines) {
  ObjRows rows;
  const auto is_blank = [lines](std::size_t at) {
    return at < lines.size() && (lines[at] == ' ' || lines[at] == '\t');
  };
  for (std::size_t at = 0; at < lines.size();) {
    while (is_blank(at)) ++at;
    if (at < lines.size() && lines[at] == 'v') {
      rows.vertices += is_blank(at + 1) ? 1 : 0;
      rows.texcoords += at + 1 < lines.size() && lines[at + 1] == 't' && is_blank(at + 2) ? 1 : 0;
      rows.normals += at + 1 < lines.size() && lines[at + 1] == 'n' && is_blank(at + 2) ? 1 : 0;
    }
    const std::size_t end = lines.find('\n', at);
    if (end == lines.npos) break;
    at = end + 1;
  }
  return rows;
}

void ObjChunk::read() {
  // A third of the lines are vertices, a line has about 30 bytes. A wrong guess costs a reallocation.
  builder_.reserve_vertices(cursor_.bytes_left() / 90);
  builder_.reserve_faces(cursor_.bytes_left() / 45);
  for (; !cursor_.at_end(); cursor_.next_line()) {
    cursor_.skip_blanks();
    if (!cursor_.at_line_end()) read_statement();
  }
}

void ObjChunk::read_statement() {
  const char* const start = cursor_.position();
  if (cursor_.peek() == '#') {
    if (cursor_.token() == "#MRGB") read_painted_colors();
    return;
  }
  const std::string_view keyword = cursor_.token();
  if (keyword == "v") {
    read_vertex();
  } else if (keyword == "f" || keyword == "fo") {
    read_face();
  } else if (keyword == "vn") {
    read_normal();
  } else if (keyword == "vt") {
    read_texcoord();
  } else if (!read_tag(keyword)) {
    const std::size_t unknown_before = others_.unknown;
    skip_other(keyword);
    if (others_.unknown != unknown_before && others_.first_unknown == nullptr) others_.first_unknown = start;
  }
}

// Returns false if the statement is another one.
bool ObjChunk::read_tag(std::string_view keyword) {
  if (keyword == "mtllib") {
    libraries_.push_back(cursor_.rest_of_line());
    return true;
  }
  struct Named {
    std::string_view keyword;
    ObjTag tag;
  };
  static constexpr Named tags[n_obj_tags] = {
      {"usemtl", ObjTag::material}, {"g", ObjTag::group}, {"o", ObjTag::object}, {"s", ObjTag::smoothing}};
  const auto* const found =
      std::find_if(std::begin(tags), std::end(tags), [&](const Named& named) { return named.keyword == keyword; });
  if (found == std::end(tags)) return false;
  std::string name = cursor_.rest_of_line();
  others_.materials += found->tag == ObjTag::material;
  others_.groups += found->tag == ObjTag::group || found->tag == ObjTag::object;
  others_.smoothing_groups += found->tag == ObjTag::smoothing && name != "off" && name != "0";
  if (name.empty() && found->tag == ObjTag::group) name = "default";  // as the manual has it
  if (!switches_.empty() && switches_.back().tag == found->tag && switches_.back().first_face == builder_.face_count())
    switches_.pop_back();  // no face had it
  switches_.push_back({builder_.face_count(), found->tag, std::move(name)});
  return true;
}

void ObjChunk::skip_other(std::string_view keyword) {
  if (keyword == "l" || keyword == "p") {
    ++others_.lines_and_points;
  } else if (keyword == "curv" || keyword == "curv2" || keyword == "surf") {
    ++others_.free_form;
  } else {
    static constexpr std::string_view harmless[] = {
        "vp",  "cstype", "deg", "bmat",  "step", "parm",       "trim",      "hole", "scrv",   "sp",
        "end", "con",    "mg",  "bevel", "lod",  "c_interp",   "d_interp",  "bsp",  "usemap", "maplib",
        "bzp", "cdc",    "cdp", "res",   "call", "shadow_obj", "trace_obj", "csh",  "ctech",  "stech"};
    for (const std::string_view known : harmless) {
      if (keyword == known) return;
    }
    ++others_.unknown;
  }
}

void ObjChunk::read_vertex() {
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
void ObjChunk::read_color(std::size_t vertex) {
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

// "#MRGB MMRRGGBBMMRRGGBB...": the mask, which is not a colour, and the colour of some vertices. Other lines are
// comments.
void ObjChunk::read_painted_colors() {
  cursor_.skip_blanks();
  const std::string_view digits = cursor_.token();
  constexpr std::size_t n_digits = 8;
  if (digits.size() % n_digits != 0) return;
  for (std::size_t at = 0; at < digits.size(); at += n_digits) {
    std::uint32_t number = 0;
    const char* const end = digits.data() + at + n_digits;
    const auto [stop, error] = std::from_chars(digits.data() + at, end, number, 16);
    if (error != std::errc{} || stop != end) return;
    const auto part = [number](unsigned shift) { return static_cast<float>((number >> shift) & 255U) / 255.0F; };
    painted_colors_.push_back({part(16), part(8), part(0), 1});
  }
}

// "vt u [v [w]]"
void ObjChunk::read_texcoord() {
  ++n_texcoords_;
  if (scope_ == AttributeScope::per_vertex) return;
  std::array<float, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    cursor_.skip_blanks();
    if (i > 0 && (cursor_.at_line_end() || cursor_.peek() == '#')) break;
    values[i] = cursor_.number<float>("a texture coordinate");
  }
  has_third_texcoord_ = has_third_texcoord_ || values[2] != 0;
  texcoords_.insert(texcoords_.end(), values.begin(), values.end());
}

void ObjChunk::read_normal() {
  std::array<float, 3> normal;
  for (float& component : normal) {
    cursor_.skip_blanks();
    component = cursor_.number<float>("a normal");
  }
  normals_.push_back(normal);
}

void ObjChunk::read_face() {
  const char* const start = cursor_.position();
  corners_.clear();
  items_.clear();
  while (cursor_.skip_blanks(), !cursor_.at_line_end() && cursor_.peek() != '#') {
    corners_.push_back(read_corner_vertex());
    if (!cursor_.at_token_end()) read_corner_rest();
  }
  // Points and lines written as faces: the builder drops and counts them. The end of the file may have cut one off.
  if (corners_.size() < 3 && cursor_.at_end()) others_.cut_face = start;
  if (!items_.empty()) items_.resize(corners_.size());
  builder_.add_polygon(corners_, items_);
}

Index ObjChunk::read_corner_vertex() {
  const char* const at = cursor_.position();
  const std::int64_t number = cursor_.integer("a vertex number");
  const auto vertices = static_cast<std::int64_t>(before_.vertices + builder_.vertex_count());
  const std::int64_t vertex = number > 0 ? number - 1 : vertices + number;
  if (number == 0) cursor_.fail(at, "vertex number 0; OBJ counts from 1");
  if (vertex < 0) {
    cursor_.fail(at, "vertex number " + std::to_string(number) + " reaches back before the first of the " +
                         std::to_string(vertices) + " vertices so far");
  }
  if (vertex > largest_vertex_.number) {
    largest_vertex_ = {vertex, at};
    if (static_cast<std::uint64_t>(vertex) >= most_elements) {
      cursor_.fail(at, "vertex number " + std::to_string(number) + " is more than the " +
                           std::to_string(most_elements) + " vertices a mesh can have");
    }
  }
  return static_cast<Index>(vertex);
}

// "/t", "//n" or "/t/n".
void ObjChunk::read_corner_rest() {
  const char* const at = cursor_.position();
  if (!cursor_.skip_if('/')) cursor_.fail_token(at, "a vertex number");
  if (!cursor_.skip_if('/')) {
    if (cursor_.at_token_end()) return;  // "1/": some programs write it
    read_corner_texcoord();
    if (cursor_.at_token_end()) return;
    if (!cursor_.skip_if('/')) cursor_.fail_token(at, "\"/\" and a normal number");
  }
  if (!cursor_.at_token_end()) read_corner_normal();
}

void ObjChunk::read_corner_texcoord() {
  const char* const at = cursor_.position();
  const std::int64_t number = cursor_.integer("a texture coordinate number");
  if (scope_ == AttributeScope::per_vertex) return;
  const auto texcoords = static_cast<std::int64_t>(before_.texcoords + n_texcoords_);
  const std::int64_t texcoord = number > 0 ? number - 1 : texcoords + number;
  if (number == 0 || texcoord < 0 || static_cast<std::uint64_t>(texcoord) >= most_elements) {
    if (bad_texcoord_.at == nullptr) bad_texcoord_ = {number, at};
    return;
  }
  if (texcoord > largest_texcoord_.number) largest_texcoord_ = {texcoord, at};
  items_.resize(corners_.size());
  items_.back().texcoord = static_cast<Index>(texcoord);
}

void ObjChunk::read_corner_normal() {
  const char* const at = cursor_.position();
  const std::int64_t number = cursor_.whole_integer("a normal number");
  const auto normals = static_cast<std::int64_t>(before_.normals + normals_.size());
  const std::int64_t normal = number > 0 ? number - 1 : normals + number;
  if (number == 0 || normal < 0 || static_cast<std::uint64_t>(normal) >= most_elements) {
    has_bad_normals_ = true;
    return;
  }
  if (normal > largest_normal_.number) largest_normal_ = {normal, at};
  items_.resize(corners_.size());
  items_.back().normal = static_cast<Index>(normal);
}

}  // namespace whittle::io
