// Wavefront OBJ ("Object Files (.obj)", Wavefront Advanced Visualizer manual, appendix B1). Reads v, vn and f. Counts
// what is not carried, for warnings: texture coordinates, names, lines, free-form geometry.
//
// A large file is read in chunks of lines, on all threads. Statements may refer to the last vertices and normals before
// them, so these are counted first.
#include <algorithm>
#include <array>
#include <compare>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "obj/obj.hh"
#include "obj/obj_chunk.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle::io {

namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, std::string_view name, unsigned threads)
      : whole_(text, name), text_(text), threads_(threads) {}

  ReadResult read(std::size_t bytes_per_chunk) {
    const std::vector<std::size_t> begins = chunk_begins(text_, bytes_per_chunk);
    if (!read_chunks(begins)) read_chunks({0});
    join_chunks();
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

  static std::vector<std::size_t> chunk_begins(std::string_view text, std::size_t bytes_per_chunk);
  bool read_chunks(const std::vector<std::size_t>& begins);
  void join_chunks();
  void reserve_for_all();
  void join_colors(std::vector<Color>& colors, std::size_t vertices_before);
  void note_corner_normals(const ObjChunk& chunk);
  void check_largest_vertex() const;
  void check_counts() const;
  void set_normals();
  void warn_of_what_is_not_carried();

  TextCursor whole_;  // For messages.
  std::string_view text_;
  unsigned threads_;
  std::vector<ObjChunk> chunks_;
  MeshBuilder builder_;

  // Faces may use vertices that come later. So the largest number is checked at the end.
  ObjChunk::LargestVertex largest_vertex_;

  std::vector<std::array<float, 3>> file_normals_;
  std::vector<Index> normal_of_vertex_;        // The first that a corner of the vertex has.
  std::vector<VertexNormal> further_normals_;  // Other ones, and those of vertices that come later.
  bool has_bad_normals_ = false;
  ObjOthers others_;
};

// At the beginnings of lines. A line that ends with a backslash goes on in the next one.
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

// Returns false if the rows of a chunk were not as many as guessed.
// Throws the first error of the file.
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
    chunks_.emplace_back(whole_.part(begins[i], end(i)), before);
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
  for (ObjChunk& chunk : chunks_) {
    note_corner_normals(chunk);
    has_bad_normals_ = has_bad_normals_ || chunk.has_bad_normals();
    file_normals_.insert(file_normals_.end(), chunk.normals().begin(), chunk.normals().end());
    others_ += chunk.others();
    if (chunk.largest_vertex().number > largest_vertex_.number) largest_vertex_ = chunk.largest_vertex();
    std::vector<Color> colors = std::move(chunk.builder().colors());
    chunk.builder().colors().clear();
    join_colors(colors, builder_.vertex_count());
    builder_.append(std::move(chunk.builder()));
  }
  chunks_.clear();
}

void ObjReader::reserve_for_all() {
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
  for (ObjChunk& chunk : chunks_) {
    n_vertices += chunk.builder().vertex_count();
    n_faces += chunk.builder().face_count();
  }
  builder_.reserve_vertices(n_vertices);
  builder_.reserve_faces(n_faces);
}

void ObjReader::join_colors(std::vector<Color>& colors, std::size_t vertices_before) {
  if (colors.empty()) return;
  auto& all = builder_.colors();
  all.resize(vertices_before, Color{opaque, opaque, opaque, opaque});
  all.insert(all.end(), colors.begin(), colors.end());
}

void ObjReader::note_corner_normals(const ObjChunk& chunk) {
  for (const auto& [vertex, normal, comes_later] : chunk.corner_normals()) {
    if (!comes_later && normal_of_vertex_.size() <= vertex) {
      normal_of_vertex_.resize(builder_.vertex_count() + chunk.rows().vertices, invalid_index);
    }
    if (!comes_later && normal_of_vertex_[vertex] == invalid_index) {
      normal_of_vertex_[vertex] = normal;
    } else if (comes_later || normal_of_vertex_[vertex] != normal) {
      further_normals_.push_back({vertex, normal});
    }
  }
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

// A mesh has one normal per vertex. Where corners differ (at a crease), it is the mean of the different normals.
void ObjReader::set_normals() {
  if (normal_of_vertex_.empty() && further_normals_.empty() && !has_bad_normals_) return;
  const std::size_t count = file_normals_.size();
  bool all_known = !has_bad_normals_;
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
  if (others_.texcoords > 0) builder_.warn("texture coordinates (vt) are not carried");
  if (others_.materials > 0) builder_.warn("materials (usemtl) are not carried");
  if (others_.groups > 1) builder_.warn("groups and object names (g, o) are not carried");
  if (others_.smoothing_groups > 0) builder_.warn("smoothing groups (s) are not carried");
  if (others_.lines_and_points > 0) builder_.warn("lines and points (l, p) are not carried");
  if (others_.free_form > 0) builder_.warn("free-form curves and surfaces (curv, surf) are not read");
  if (others_.unknown > 0) {
    builder_.warn(std::to_string(others_.unknown) + " unknown statements ignored, the first in line " +
                  std::to_string(whole_.line_of(others_.first_unknown)) + ": \"" +
                  whole_.excerpt(others_.first_unknown) + '"');
  }
}

}  // namespace

ReadResult read_obj(std::string_view bytes, std::string_view name, unsigned threads) {
  const std::string_view text = without_byte_order_mark(bytes);
  constexpr std::size_t least = std::size_t{1} << 20;  // some milliseconds of work
  constexpr std::size_t most_chunks = 64;
  return read_obj_in_chunks(
      text, name, n_threads(threads) == 1 ? text.size() : std::max(least, text.size() / most_chunks), threads);
}

ReadResult read_obj_in_chunks(std::string_view text, std::string_view name, std::size_t bytes_per_chunk,
                              unsigned threads) {
  return ObjReader(text, name, threads).read(bytes_per_chunk);
}

}  // namespace whittle::io
