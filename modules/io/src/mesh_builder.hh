#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/io/read.hh"

namespace whittle::io {

/// Most vertices, or faces, a mesh can have: `invalid_index` is none of them.
inline constexpr std::uint64_t most_elements = invalid_index;

/// Opacity of a colour stored without one, in whichever scale.
inline constexpr float opaque = std::numeric_limits<float>::infinity();

/// Collects what a reader finds. Faces may come before the positions of their corners: polygons are triangulated in
/// `finish`, in the places they had among the faces.
class MeshBuilder {
 public:
  std::vector<Vec3>& positions() { return result_.mesh.positions; }
  /// 0…1 or 0…255, as stored; `finish` brings them to [0, 1], by 255 if one is larger than 1. Missing opacity:
  /// `opaque`.
  std::vector<Color>& colors() { return result_.mesh.colors; }
  /// As stored, of any length; `finish` brings them to unit length.
  std::vector<std::array<float, 3>>& normals() { return result_.mesh.normals; }

  std::size_t vertex_count() const { return result_.mesh.positions.size(); }

  /// For at most as many elements as the file's size allows.
  void reserve_faces(std::size_t count) { result_.mesh.faces.reserve(count); }

  void add_triangle(const Triangle& face) {
    ++result_.file_faces;
    result_.mesh.faces.push_back(face);
  }
  /// Any number of corners. Repeated neighbours count once; fewer than three different ones make a degenerate face.
  void add_polygon(std::span<const Index> corners);

  void warn(std::string warning) { result_.warnings.push_back(std::move(warning)); }

  /// Triangulates, scales colours, normalises normals and numbers the origins.
  ReadResult finish();

 private:
  struct Polygon {
    std::size_t first_face;  // of the n − 2 that are reserved for it
    std::size_t first_corner;
    std::size_t corners;
  };

  void triangulate();
  void scale_colors();
  void normalize_normals();

  ReadResult result_;
  std::vector<Polygon> polygons_;
  std::vector<Index> polygon_corners_;
  std::vector<Index> scratch_;
};

}  // namespace whittle::io
