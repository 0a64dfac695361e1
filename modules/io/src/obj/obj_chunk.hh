#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <vector>

#include "bytes/text_cursor.hh"
#include "format/mesh_builder.hh"

namespace whittle::io {

/// Numbers of vertices (v) and of normals (vn). Statements may refer to the last ones before them.
struct ObjRows {
  std::size_t vertices = 0;
  std::size_t normals = 0;

  ObjRows& operator+=(const ObjRows& more) {
    vertices += more.vertices;
    normals += more.normals;
    return *this;
  }
  bool operator==(const ObjRows&) const = default;
};

/// Statements that a mesh can't carry, or that are not known.
struct ObjOthers {
  std::size_t texcoords = 0;
  std::size_t materials = 0;
  std::size_t groups = 0;
  std::size_t smoothing_groups = 0;
  std::size_t lines_and_points = 0;
  std::size_t free_form = 0;
  std::size_t unknown = 0;
  const char* first_unknown = nullptr;

  ObjOthers& operator+=(const ObjOthers& more);
};

/// Some lines of an OBJ file, and what they say. Vertex numbers are those of the whole file.
class ObjChunk {
 public:
  struct CornerNormal {
    Index vertex;
    Index normal;      ///< a number into those of the file
    bool comes_later;  ///< the vertex
    auto operator<=>(const CornerNormal&) const = default;
  };
  /// The vertex with the largest number that a face names. It may come later in the file.
  struct LargestVertex {
    std::int64_t number = -1;
    const char* at = nullptr;
  };

  /// \param lines a part of the file \param before it
  ObjChunk(const TextCursor& lines, const ObjRows& before) : cursor_(lines), before_(before) {}

  /// Counts the rows in some lines, without reading them. Lines that go on in the next may deceive it.
  static ObjRows guess_rows(std::string_view lines);

  /// \throw ReadError
  void read();

  ObjRows rows() const { return {builder_.vertex_count(), normals_.size()}; }
  /// Colours as far as there are any: later vertices may lack them.
  MeshBuilder& builder() { return builder_; }
  const std::vector<std::array<float, 3>>& normals() const { return normals_; }
  /// In the order of the file; at each vertex not the same twice in a row.
  const std::vector<CornerNormal>& corner_normals() const { return corner_normals_; }
  bool has_bad_normals() const { return has_bad_normals_; }
  const LargestVertex& largest_vertex() const { return largest_vertex_; }
  const ObjOthers& others() const { return others_; }

 private:
  void read_statement();
  void read_vertex();
  void read_color(std::size_t vertex);
  void read_normal();
  void read_face();
  Index read_corner_vertex();
  void read_corner_rest(Index vertex);
  void note_corner_normal(Index vertex);
  void skip_other(std::string_view keyword);

  TextCursor cursor_;
  ObjRows before_;
  MeshBuilder builder_;
  std::vector<Index> corners_;  ///< of the face being read
  LargestVertex largest_vertex_;
  std::vector<std::array<float, 3>> normals_;
  std::vector<CornerNormal> corner_normals_;
  bool has_bad_normals_ = false;
  ObjOthers others_;
};

}  // namespace whittle::io
