#include "format/mesh_builder.hh"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "repair/triangulate.hh"

namespace whittle::io {

void MeshBuilder::add_triangles(std::vector<Triangle> faces) {
  result_.file_faces += faces.size();
  if (result_.mesh.faces.empty()) {
    result_.mesh.faces = std::move(faces);
  } else {
    result_.mesh.faces.insert(result_.mesh.faces.end(), faces.begin(), faces.end());
  }
}

void MeshBuilder::append(MeshBuilder&& more) {
  const auto move_to_end = [](auto& to, auto& from) {
    if (to.capacity() == 0) {
      to = std::move(from);
    } else {
      to.insert(to.end(), from.begin(), from.end());
    }
  };
  for (Polygon& polygon : more.polygons_) {
    polygon.first_face += result_.mesh.faces.size();
    polygon.first_corner += polygon_corners_.size();
  }
  move_to_end(polygons_, more.polygons_);
  move_to_end(polygon_corners_, more.polygon_corners_);
  move_to_end(result_.mesh.positions, more.result_.mesh.positions);
  move_to_end(result_.mesh.faces, more.result_.mesh.faces);
  result_.file_faces += more.result_.file_faces;
  result_.repairs += more.result_.repairs;
}

void MeshBuilder::add_polygon(std::span<const Index> corners) {
  if (corners.size() == 3) {
    add_triangle({corners[0], corners[1], corners[2]});
    return;
  }
  ++result_.file_faces;
  scratch_.clear();
  for (const Index corner : corners) {
    if (scratch_.empty() || scratch_.back() != corner) scratch_.push_back(corner);
  }
  while (scratch_.size() > 1 && scratch_.back() == scratch_.front()) scratch_.pop_back();
  if (scratch_.size() < 3) {
    ++result_.repairs.degenerate_faces;
    return;
  }
  auto& faces = result_.mesh.faces;
  if (scratch_.size() > 3) {
    ++result_.repairs.triangulated_polygons;
    polygons_.push_back({faces.size(), polygon_corners_.size(), scratch_.size()});
    polygon_corners_.insert(polygon_corners_.end(), scratch_.begin(), scratch_.end());
  }
  for (std::size_t i = 2; i < scratch_.size(); ++i) faces.push_back({scratch_[0], scratch_[i - 1], scratch_[i]});
}

void MeshBuilder::triangulate() {
  PolygonTriangulator triangulator;
  const std::span<const Index> corners(polygon_corners_);
  const std::span<Triangle> faces(result_.mesh.faces);
  for (const Polygon& polygon : polygons_) {
    triangulator.triangulate(corners.subspan(polygon.first_corner, polygon.corners), result_.mesh.positions,
                             faces.subspan(polygon.first_face, polygon.corners - 2));
  }
}

// Some programs write real numbers a little above 1 for full intensity. Only what is clearly above 1 means 0…255.
void MeshBuilder::scale_colors() {
  const auto is_byte_scale = [](float c) { return c > 1.5F && c < opaque; };
  float full = 1;
  for (const Color& color : result_.mesh.colors) {
    if (std::any_of(color.begin(), color.end(), is_byte_scale)) full = 255;
  }
  for (Color& color : result_.mesh.colors) {
    for (float& c : color) c = c > 0 ? std::min(c / full, 1.0F) : 0.0F;  // NaN becomes 0.
  }
}

// A normal that is of unit length up to the rounding of its digits stays, so that reading and writing keep it.
void MeshBuilder::normalize_normals() {
  for (auto& n : result_.mesh.normals) {
    double square = 0;  // of floats: neither too large nor too small for a double
    for (const double c : n) square += c * c;
    const double length = std::sqrt(square);
    if (std::abs(length - 1) < 1e-4) continue;
    if (!(length > 0) || !std::isfinite(length)) {
      n = {0, 0, 0};
      continue;
    }
    for (float& c : n) c = static_cast<float>(c / length);
  }
}

ReadResult MeshBuilder::finish() {
  triangulate();
  scale_colors();
  normalize_normals();
  IndexedMesh& mesh = result_.mesh;
  result_.file_vertices = mesh.positions.size();
  resize_large(mesh.origins, mesh.positions.size());
  std::iota(mesh.origins.begin(), mesh.origins.end(), Index{0});
  return std::move(result_);
}

}  // namespace whittle::io
