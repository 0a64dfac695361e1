#include "format/mesh_builder.hh"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "repair/triangulate.hh"
#include "whittle/core/attribute_kinds.hh"

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
    if (polygon.first_item != no_items) polygon.first_item += polygon_items_.size();
  }
  if (!more.corner_items().empty()) {
    corner_items().resize(3 * face_count());
    move_to_end(corner_items(), more.corner_items());
  }
  move_to_end(polygons_, more.polygons_);
  move_to_end(polygon_corners_, more.polygon_corners_);
  move_to_end(polygon_items_, more.polygon_items_);
  move_to_end(result_.mesh.positions, more.result_.mesh.positions);
  move_to_end(result_.mesh.faces, more.result_.mesh.faces);
  result_.file_faces += more.result_.file_faces;
  result_.repairs += more.result_.repairs;
}

void MeshBuilder::add_items(std::span<const CornerItems> items) {
  corner_items().insert(corner_items().end(), items.begin(), items.end());
}

void MeshBuilder::add_polygon(std::span<const Index> corners, std::span<const CornerItems> items) {
  if (!items.empty()) corner_items().resize(3 * face_count());
  if (corners.size() == 3) {
    add_triangle({corners[0], corners[1], corners[2]});
    if (!items.empty()) add_items(items);
    return;
  }
  ++result_.file_faces;
  scratch_.clear();
  scratch_items_.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!scratch_.empty() && scratch_.back() == corners[i]) continue;
    scratch_.push_back(corners[i]);
    if (!items.empty()) scratch_items_.push_back(items[i]);
  }
  while (scratch_.size() > 1 && scratch_.back() == scratch_.front()) scratch_.pop_back();
  scratch_items_.resize(items.empty() ? 0 : scratch_.size());
  if (scratch_.size() < 3) {
    ++result_.repairs.degenerate_faces;
    return;
  }
  if (scratch_.size() > 3) {
    ++result_.repairs.triangulated_polygons;
    polygons_.push_back({face_count(), polygon_corners_.size(), scratch_.size(),
                         scratch_items_.empty() ? no_items : polygon_items_.size()});
    polygon_corners_.insert(polygon_corners_.end(), scratch_.begin(), scratch_.end());
    polygon_items_.insert(polygon_items_.end(), scratch_items_.begin(), scratch_items_.end());
  }
  for (std::size_t i = 2; i < scratch_.size(); ++i) {
    result_.mesh.faces.push_back({scratch_[0], scratch_[i - 1], scratch_[i]});
    if (!items.empty()) add_items(std::array{scratch_items_[0], scratch_items_[i - 1], scratch_items_[i]});
  }
}

void MeshBuilder::forget_normals() {
  for (std::vector<CornerItems>* const items : {&corner_items(), &polygon_items_}) {
    for (CornerItems& item : *items) item.normal = invalid_index;
  }
}

void MeshBuilder::forget_texcoords() {
  for (std::vector<CornerItems>* const items : {&corner_items(), &polygon_items_}) {
    for (CornerItems& item : *items) item.texcoord = invalid_index;
  }
}

void MeshBuilder::triangulate() {
  PolygonTriangulator triangulator;
  const std::span<Triangle> faces(result_.mesh.faces);
  for (const Polygon& polygon : polygons_) {
    const auto corners = std::span<const Index>(polygon_corners_).subspan(polygon.first_corner, polygon.corners);
    const std::span<Triangle> parts = faces.subspan(polygon.first_face, polygon.corners - 2);
    triangulator.triangulate(corners, result_.mesh.positions, parts);
    for (std::size_t corner = 0; corner < 3 * parts.size() && polygon.first_item != no_items; ++corner) {
      const Index place = parts[corner / 3][corner % 3];
      corner_items()[3 * polygon.first_face + corner] = polygon_items_[polygon.first_item + place];
    }
    for (Triangle& part : parts) part = {corners[part[0]], corners[part[1]], corners[part[2]]};
  }
}

// Some programs write real numbers a little above 1 for full intensity. Only numbers clearly above 1 mean 0…255.
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

namespace {

// A normal that is of unit length up to the rounding of its digits stays, so that reading and writing keep it.
void normalize(std::vector<std::array<float, 3>>& normals) {
  for (auto& n : normals) {
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

}  // namespace

void MeshBuilder::take_corner_values(AttributeScope scope) {
  IndexedMesh& mesh = result_.mesh;
  if (!corner_items().empty()) corner_items().resize(3 * face_count());
  if (scope == AttributeScope::all) {
    normalize(corner_normals());
    set_corner_values(mesh, std::move(corner_values_));
    return;
  }
  const bool has_normals = std::any_of(corner_items().begin(), corner_items().end(),
                                       [](const CornerItems& items) { return items.normal != invalid_index; });
  if (!has_normals) return;
  bool are_summed = false;
  set_vertex_normals(mesh, corner_values_, are_summed);
  normalize(mesh.normals);
  if (are_summed) warn("normals that differ between the corners of a vertex were averaged");
}

void MeshBuilder::make_texcoords_finite() {
  bool are_finite = true;
  for (Attribute& attribute : result_.mesh.attributes) {
    if (attribute.kind != AttributeKind::texcoord) continue;
    for (double& x : attribute.values) {
      if (std::isfinite(x)) continue;
      x = 0;
      are_finite = false;
    }
  }
  if (!are_finite) warn("texture coordinates that are not finite became 0");
}

ReadResult MeshBuilder::finish(AttributeScope scope) {
  triangulate();
  scale_colors();
  normalize(result_.mesh.normals);
  take_corner_values(scope);
  make_texcoords_finite();
  find_whole_categories(result_.mesh);
  IndexedMesh& mesh = result_.mesh;
  for (Attribute& attribute : mesh.face_attributes) attribute.values.resize(face_count() * attribute.n_components, 0);
  result_.file_vertices = mesh.positions.size();
  resize_large(mesh.origins, mesh.positions.size());
  std::iota(mesh.origins.begin(), mesh.origins.end(), Index{0});
  return std::move(result_);
}

}  // namespace whittle::io
