#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bytes/text_cursor.hh"
#include "format/mesh_builder.hh"

namespace whittle::io {

/// Numbers of vertices (v), texture coordinates (vt) and normals (vn). Statements may refer to the last ones before
/// them.
struct ObjRows {
  std::size_t vertices = 0;
  std::size_t texcoords = 0;
  std::size_t normals = 0;

  ObjRows& operator+=(const ObjRows& more) {
    vertices += more.vertices;
    texcoords += more.texcoords;
    normals += more.normals;
    return *this;
  }
  bool operator==(const ObjRows&) const = default;
};

/// Numbers of statements that a mesh may not carry, or that are not known.
struct ObjOthers {
  std::size_t materials = 0;
  std::size_t groups = 0;  ///< of objects, too
  std::size_t smoothing_groups = 0;
  std::size_t lines_and_points = 0;
  std::size_t free_form = 0;
  std::size_t unknown = 0;
  const char* first_unknown = nullptr;
  const char* cut_face = nullptr;  ///< of fewer than three corners, and the file ends with it, without a line end

  ObjOthers& operator+=(const ObjOthers& more);
};

/// Properties that a statement gives to the faces after it.
enum class ObjTag : std::size_t { material, group, object, smoothing };
inline constexpr std::size_t n_obj_tags = 4;

/// A statement that gives the faces after it a tag: `usemtl`, `g`, `o` or `s`.
struct ObjSwitch {
  std::size_t first_face;  ///< a number of triangles before it
  ObjTag tag;
  std::string name;
};

/// A number that a corner of a face has, and where it stands.
struct ObjNumber {
  std::int64_t number = -1;
  const char* at = nullptr;
};

/// Content of some lines of an OBJ file. Numbers of vertices, texture coordinates and normals refer to the whole file.
class ObjChunk {
 public:
  /// \param lines a part of the file \param before it
  ObjChunk(const TextCursor& lines, const ObjRows& before, AttributeScope scope)
      : cursor_(lines), before_(before), scope_(scope) {}

  /// Counts the rows in some lines, without reading them. Lines that go on in the next may deceive it.
  static ObjRows guess_rows(std::string_view lines);

  /// \throw ReadError
  void read();

  ObjRows rows() const { return {builder_.vertex_count(), n_texcoords_, normals().size()}; }
  /// Colours as far as there are any: later vertices may lack them.
  MeshBuilder& builder() { return builder_; }
  const std::vector<std::array<float, 3>>& normals() const { return normals_; }
  /// Three numbers each; empty if only vertices have attributes.
  const std::vector<float>& texcoords() const { return texcoords_; }
  /// Colours from comments of ZBrush, vertex by vertex: `#MRGB`.
  const std::vector<Color>& painted_colors() const { return painted_colors_; }
  bool has_third_texcoord() const { return has_third_texcoord_; }  ///< that isn't zero
  bool has_bad_normals() const { return has_bad_normals_; }
  /// The largest number that a face names. It may come later in the file.
  const ObjNumber& largest_vertex() const { return largest_vertex_; }
  const ObjNumber& largest_texcoord() const { return largest_texcoord_; }
  const ObjNumber& largest_normal() const { return largest_normal_; }
  /// The first number of a texture coordinate that can't be one, as it stands. `at` is null if there is none.
  const ObjNumber& bad_texcoord() const { return bad_texcoord_; }
  const std::vector<ObjSwitch>& switches() const { return switches_; }
  const std::vector<std::string>& libraries() const { return libraries_; }  ///< names after `mtllib`
  const ObjOthers& others() const { return others_; }

 private:
  void read_statement();
  void read_vertex();
  void read_color(std::size_t vertex);
  void read_painted_colors();
  void read_texcoord();
  void read_normal();
  void read_face();
  Index read_corner_vertex();
  void read_corner_rest();
  void read_corner_texcoord();
  void read_corner_normal();
  bool read_tag(std::string_view keyword);
  void skip_other(std::string_view keyword);

  TextCursor cursor_;
  ObjRows before_;
  AttributeScope scope_;
  MeshBuilder builder_;
  // Of the face being read.
  std::vector<Index> corners_;
  std::vector<CornerItems> items_;  // Empty if no corner names any.

  ObjNumber largest_vertex_;
  ObjNumber largest_texcoord_;
  ObjNumber largest_normal_;
  ObjNumber bad_texcoord_;
  std::vector<std::array<float, 3>> normals_;
  std::vector<float> texcoords_;
  std::vector<Color> painted_colors_;
  std::size_t n_texcoords_ = 0;
  bool has_third_texcoord_ = false;
  bool has_bad_normals_ = false;
  std::vector<ObjSwitch> switches_;
  std::vector<std::string> libraries_;
  ObjOthers others_;
};

}  // namespace whittle::io
