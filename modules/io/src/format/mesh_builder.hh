#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "format/corner_values.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/read.hh"

namespace whittle::io {

/// The largest number of vertices, or of faces, that a mesh can have: `invalid_index` is the number of none.
inline constexpr std::uint64_t most_elements = invalid_index;

/// Opacity of a colour that the file stores without one, in any scale.
inline constexpr float opaque = std::numeric_limits<float>::infinity();

/// Collects the content of a file. Faces may come before the positions of their corners: polygons are triangulated in
/// `finish`. Their triangles keep the polygon's position in the order of faces.
class MeshBuilder {
 public:
  std::vector<Vec3>& positions() { return result_.mesh.positions; }
  /// As stored: 0…1 or 0…255. `finish` scales them to [0, 1]: by 1/255 if one is clearly above 1. Missing opacity:
  /// `opaque`.
  std::vector<Color>& colors() { return result_.mesh.colors; }
  /// As stored, of any length. `finish` scales them to unit length.
  std::vector<std::array<float, 3>>& normals() { return result_.mesh.normals; }

  /// As stored.
  std::vector<double>& tolerances() { return result_.tolerances; }

  /// All other attributes, in their final form. Attributes of faces are for the triangles so far; `finish` gives zeros
  /// to the others.
  IndexedMesh& mesh() { return result_.mesh; }
  FileNotes& notes() { return result_.notes; }

  /// The values that corners of faces name (`CornerItems`). Normals are as stored.
  Attribute& corner_texcoords() { return corner_values_.texcoords; }
  /// Likewise.
  std::vector<std::array<float, 3>>& corner_normals() { return corner_values_.normals; }
  /// 3 for each triangle, or fewer: the others name nothing.
  std::vector<CornerItems>& corner_items() { return corner_values_.corners; }

  std::size_t vertex_count() const { return result_.mesh.positions.size(); }
  std::size_t face_count() const { return result_.mesh.faces.size(); }

  /// \pre `count` was checked against the file's size.
  void reserve_vertices(std::size_t count) { reserve_large(result_.mesh.positions, count); }
  /// \pre as above
  void reserve_faces(std::size_t count) { reserve_large(result_.mesh.faces, count); }

  void add_triangle(const Triangle& face) {
    ++result_.file_faces;
    result_.mesh.faces.push_back(face);
  }
  void add_triangles(std::vector<Triangle> faces);
  /// Any number of corners. A corner that repeats its neighbour is left out. With fewer than three corners left, the
  /// face is counted as degenerate. \param items per corner, or empty
  void add_polygon(std::span<const Index> corners, std::span<const CornerItems> items = {});

  /// Appends the vertices, faces and corner values of another builder. Numbers refer to the whole.
  void append(MeshBuilder&& more);

  /// No corner names a normal any more.
  void forget_normals();
  /// Likewise a texture coordinate.
  void forget_texcoords();

  void warn(std::string warning) { result_.warnings.push_back(std::move(warning)); }

  /// Triangulates, scales colours and normals, gives vertices or wedges the values of corners, and fills in the
  /// origins.
  ReadResult finish(AttributeScope scope = AttributeScope::all);

 private:
  struct Polygon {
    std::size_t first_face;  // Of the n − 2 that are reserved for it.
    std::size_t first_corner;
    std::size_t corners;
    std::size_t first_item;  // `no_items` if the corners name nothing.
  };
  static constexpr std::size_t no_items = ~std::size_t{0};

  void add_items(std::span<const CornerItems> items);
  void triangulate();
  void scale_colors();
  void take_corner_values(AttributeScope scope);
  void make_texcoords_finite();

  ReadResult result_;
  std::vector<Polygon> polygons_;
  std::vector<Index> polygon_corners_;
  std::vector<CornerItems> polygon_items_;
  CornerValues corner_values_;
  std::vector<Index> scratch_;
  std::vector<CornerItems> scratch_items_;
};

}  // namespace whittle::io
