// Wavefront OBJ ("Object Files (.obj)", Wavefront Advanced Visualizer manual, appendix B1). Reads v, vt, vn, f, and
// materials, groups, objects and smoothing groups of faces. Counts lost content, for warnings: lines, free-form
// geometry.
//
// A large file is read in chunks of lines, on all threads. Statements may refer to the last vertices, texture
// coordinates and normals before them, so these are counted first.
#include <algorithm>
#include <array>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "obj/obj.hh"
#include "obj/obj_chunk.hh"
#include "obj/obj_tags.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle::io {

namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, std::string_view name, const ReadOptions& options)
      : whole_(text, name), text_(text), threads_(options.threads), scope_(options.attributes) {}

  ReadResult read(std::size_t bytes_per_chunk) {
    const std::vector<std::size_t> begins = chunk_begins(text_, bytes_per_chunk);
    if (!read_chunks(begins)) read_chunks({0});
    join_chunks();
    check_largest_vertex();
    check_counts();
    check_normals();
    set_painted_colors();
    set_texcoords();
    if (scope_ == AttributeScope::all) tags_.give_to(builder_);
    warn_of_what_is_not_carried();
    return builder_.finish(scope_);
  }

 private:
  static std::vector<std::size_t> chunk_begins(std::string_view text, std::size_t bytes_per_chunk);
  bool read_chunks(const std::vector<std::size_t>& begins);
  void join_chunks();
  void reserve_for_all();
  void join_colors(std::vector<Color>& colors, std::size_t vertices_before);
  void check_largest_vertex() const;
  void check_counts() const;
  void check_normals();
  void set_painted_colors();
  void set_texcoords();
  void warn_of_what_is_not_carried();

  TextCursor whole_;  // For messages.
  std::string_view text_;
  unsigned threads_;
  AttributeScope scope_;
  std::vector<ObjChunk> chunks_;
  MeshBuilder builder_;

  // Faces may use vertices that come later. So the largest numbers are checked at the end.
  ObjNumber largest_vertex_;
  ObjNumber largest_texcoord_;
  ObjNumber largest_normal_;
  ObjNumber bad_texcoord_;
  ObjRows rows_;
  std::vector<float> texcoords_;
  std::vector<Color> painted_colors_;
  bool has_third_texcoord_ = false;
  bool has_bad_normals_ = false;
  ObjTags tags_;
  ObjOthers others_;
};

// Chunks begin at lines. A line that ends with a backslash goes on in the next line.
std::vector<std::size_t> ObjReader::chunk_begins(std::string_view text, std::size_t bytes_per_chunk) {
  std::vector<std::size_t> begins{0};
  const auto is_continued = [text](std::size_t end) {
    if (end > 0 && text[end - 1] == '\r') --end;
    return end > 0 && text[end - 1] == '\\';
  };
  while (text.size() - begins.back() > bytes_per_chunk) {
    std::size_t end = text.find('\n', begins.back() + bytes_per_chunk);
    while (end != text.npos && is_continued(end)) end = text.find('\n', end + 1);
    if (end == text.npos || end + 1 == text.size()) break;
    begins.push_back(end + 1);
  }
  return begins;
}

// Returns false if the number of rows in a chunk differs from the guess. Throws the first error of the file.
bool ObjReader::read_chunks(const std::vector<std::size_t>& begins) {
  const std::size_t n = begins.size();
  const auto end = [&](std::size_t i) { return i + 1 < n ? begins[i + 1] : text_.size(); };
  std::vector<ObjRows> rows(n);
  if (n > 1)
    for_each_block(n, threads_,
                   [&](std::size_t i) { rows[i] = ObjChunk::guess_rows(text_.substr(begins[i], end(i) - begins[i])); });
  chunks_.clear();
  ObjRows before;
  for (std::size_t i = 0; i < n; ++i) {
    chunks_.emplace_back(whole_.part(begins[i], end(i)), before, scope_);
    before += rows[i];
  }
  std::vector<std::exception_ptr> errors(n);
  for_each_block(n, threads_, [&](std::size_t i) {
    try {
      chunks_[i].read();
    } catch (const ReadError&) {
      errors[i] = std::current_exception();
    }
  });
  for (std::size_t i = 0; i < n; ++i) {
    if (errors[i]) std::rethrow_exception(errors[i]);
    if (n > 1 && chunks_[i].rows() != rows[i]) return false;
  }
  return true;
}

void ObjReader::join_chunks() {
  if (chunks_.size() > 1) reserve_for_all();
  const auto keep_larger = [](ObjNumber& largest, const ObjNumber& other) {
    if (other.number > largest.number) largest = other;
  };
  for (ObjChunk& chunk : chunks_) {
    has_bad_normals_ = has_bad_normals_ || chunk.has_bad_normals();
    has_third_texcoord_ = has_third_texcoord_ || chunk.has_third_texcoord();
    if (bad_texcoord_.at == nullptr) bad_texcoord_ = chunk.bad_texcoord();
    builder_.corner_normals().insert(builder_.corner_normals().end(), chunk.normals().begin(), chunk.normals().end());
    texcoords_.insert(texcoords_.end(), chunk.texcoords().begin(), chunk.texcoords().end());
    painted_colors_.insert(painted_colors_.end(), chunk.painted_colors().begin(), chunk.painted_colors().end());
    others_ += chunk.others();
    rows_ += chunk.rows();
    keep_larger(largest_vertex_, chunk.largest_vertex());
    keep_larger(largest_texcoord_, chunk.largest_texcoord());
    keep_larger(largest_normal_, chunk.largest_normal());
    tags_.add(chunk, builder_.face_count());
    std::vector<Color> colors = std::move(chunk.builder().colors());
    chunk.builder().colors().clear();
    join_colors(colors, builder_.vertex_count());
    builder_.append(std::move(chunk.builder()));
  }
  chunks_.clear();
}

void ObjReader::reserve_for_all() {
  ObjRows rows;
  std::size_t n_faces = 0;
  bool has_items = false;
  for (ObjChunk& chunk : chunks_) {
    rows += chunk.rows();
    n_faces += chunk.builder().face_count();
    has_items = has_items || !chunk.builder().corner_items().empty();
  }
  builder_.reserve_vertices(rows.vertices);
  builder_.reserve_faces(n_faces);
  reserve_large(builder_.corner_normals(), rows.normals);
  if (scope_ == AttributeScope::all) reserve_large(texcoords_, 3 * rows.texcoords);
  if (has_items) reserve_large(builder_.corner_items(), 3 * n_faces);
}

void ObjReader::join_colors(std::vector<Color>& colors, std::size_t vertices_before) {
  if (colors.empty()) return;
  auto& all = builder_.colors();
  all.resize(vertices_before, Color{opaque, opaque, opaque, opaque});
  all.insert(all.end(), colors.begin(), colors.end());
}

void ObjReader::check_largest_vertex() const {
  const std::size_t vertices = builder_.vertex_count();
  const auto& [number, at] = largest_vertex_;
  if (number < 0 || static_cast<std::uint64_t>(number) < vertices) return;
  whole_.fail(at, "vertex number " + std::to_string(number + 1) + ", but the file has " + std::to_string(vertices) +
                      " vertices; it may be truncated");
}

void ObjReader::check_counts() const {
  if (builder_.vertex_count() > most_elements) {
    whole_.fail("more than the " + std::to_string(most_elements) + " vertices a mesh can have");
  }
}

void ObjReader::check_normals() {
  const auto count = static_cast<std::int64_t>(builder_.corner_normals().size());
  if (!has_bad_normals_ && largest_normal_.number < count) return;
  builder_.warn("normals are ignored: faces use numbers of normals that the file doesn't have");
  builder_.forget_normals();
}

// Colours behind positions come before colours in comments: most programs read and write the former.
void ObjReader::set_painted_colors() {
  if (painted_colors_.empty() || !builder_.colors().empty()) return;
  if (painted_colors_.size() != builder_.vertex_count()) {
    return builder_.warn("colours in comments (#MRGB) are ignored: there are " +
                         std::to_string(painted_colors_.size()) + " for " + std::to_string(builder_.vertex_count()) +
                         " vertices");
  }
  builder_.colors() = std::move(painted_colors_);
}

// Numbers of texture coordinates are left in files from which the coordinates were taken out. Other wrong numbers are
// errors.
void ObjReader::set_texcoords() {
  if (rows_.texcoords == 0 || scope_ == AttributeScope::per_vertex) {
    const bool has_any = bad_texcoord_.at != nullptr || largest_texcoord_.number >= 0;
    if (has_any) builder_.warn("texture coordinates are ignored: faces use numbers of some, but the file has none");
    builder_.forget_texcoords();
    return;
  }
  const std::string of_the_file = ", but the file has " + std::to_string(rows_.texcoords);
  if (bad_texcoord_.at != nullptr) {
    whole_.fail(bad_texcoord_.at, "texture coordinate number " + std::to_string(bad_texcoord_.number) +
                                      (bad_texcoord_.number == 0 ? "; OBJ counts from 1" : of_the_file));
  }
  if (static_cast<std::uint64_t>(largest_texcoord_.number + 1) > rows_.texcoords) {
    whole_.fail(largest_texcoord_.at, "texture coordinate number " + std::to_string(largest_texcoord_.number + 1) +
                                          of_the_file + "; it may be truncated");
  }
  Attribute& texcoords = builder_.corner_texcoords();
  texcoords.name = "vt";
  texcoords.n_components = has_third_texcoord_ ? 3 : 2;
  resize_large(texcoords.values, texcoords.n_components * rows_.texcoords);
  for (std::size_t i = 0; i < rows_.texcoords; ++i) {
    for (std::size_t k = 0; k < texcoords.n_components; ++k) texcoords.value(i)[k] = double{texcoords_[3 * i + k]};
  }
}

void ObjReader::warn_of_what_is_not_carried() {
  auto& colors = builder_.colors();
  if (!colors.empty()) colors.resize(builder_.vertex_count(), Color{opaque, opaque, opaque, opaque});
  if (scope_ == AttributeScope::per_vertex) {
    if (rows_.texcoords > 0) builder_.warn("texture coordinates (vt) are not carried");
    if (others_.materials > 0) builder_.warn("materials (usemtl) are not carried");
    if (others_.groups > 1) builder_.warn("groups and object names (g, o) are not carried");
    if (others_.smoothing_groups > 0) builder_.warn("smoothing groups (s) are not carried");
  }
  if (others_.lines_and_points > 0) builder_.warn("lines and points (l, p) are not carried");
  if (others_.free_form > 0) builder_.warn("free-form curves and surfaces (curv, surf) are not read");
  if (others_.cut_face != nullptr) {
    builder_.warn("the file ends in line " + std::to_string(whole_.line_of(others_.cut_face)) +
                  " within a face: it may be truncated");
  }
  if (others_.unknown > 0) {
    builder_.warn(std::to_string(others_.unknown) + " unknown statements ignored, the first in line " +
                  std::to_string(whole_.line_of(others_.first_unknown)) + ": \"" +
                  whole_.excerpt(others_.first_unknown) + '"');
  }
}

}  // namespace

ReadResult read_obj(std::string_view bytes, std::string_view name, const ReadOptions& options) {
  const std::string_view text = without_byte_order_mark(bytes);
  constexpr std::size_t least = std::size_t{1} << 20;  // some milliseconds of work
  constexpr std::size_t most_chunks = 64;
  const bool is_one = n_threads(options.threads) == 1;
  return read_obj_in_chunks(text, name, is_one ? text.size() : std::max(least, text.size() / most_chunks), options);
}

ReadResult read_obj_in_chunks(std::string_view text, std::string_view name, std::size_t bytes_per_chunk,
                              const ReadOptions& options) {
  return ObjReader(text, name, options).read(bytes_per_chunk);
}

}  // namespace whittle::io
