#include "whittle/core/geometry/proof/target_surface.hh"

#include <algorithm>
#include <cmath>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/geometry/nearest_on_triangle.hh"
#include "whittle/core/geometry/segment.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {
namespace {

IndexedMesh in_frame(const IndexedMesh& mesh, const Frame& frame) {
  IndexedMesh result;
  result.faces = mesh.faces;
  result.positions.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) result.positions.push_back(frame.to_frame(p));
  return result;
}

LargeArray<FacesBeyond> faces_beyond(const IndexedMesh& mesh) {
  LargeArray<FacesBeyond> beyond(mesh.faces.size(), {invalid_index, invalid_index, invalid_index});
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> sides = edges.sides(e);
    if (sides.size() != 2) continue;
    beyond[sides[0] / 3][sides[0] % 3] = sides[1] / 3;
    beyond[sides[1] / 3][sides[1] % 3] = sides[0] / 3;
  }
  return beyond;
}

}  // namespace

TargetSurface::TargetSurface(const IndexedMesh& mesh, const Frame& frame, std::span<const double> limits, double limit)
    : in_frame_(whittle::in_frame(mesh, frame)), beyond_(faces_beyond(in_frame_)) {
  offsets_.reserve(limits.size());
  for (const double of_face : limits) offsets_.push_back(limit - of_face);
}

void TargetSurface::build_tree(detail::ProgressMeter* meter) const {
  std::call_once(once_, [&] {
    tree_.emplace(in_frame_, Vec3::Zero(), meter);
    if (!offsets_.empty()) tree_->set_offsets(offsets_);
    has_tree_ = true;
  });
}

NearFace TargetSurface::nearest_without_tree(const Vec3& point) const {
  if (!offsets_.empty()) {
    const auto [face, distance] = TriangleTree::nearest_without_tree(in_frame_, offsets_, point);
    return {face, distance};
  }
  const ClosestPoint closest = TriangleTree::nearest_without_tree(in_frame_, point);
  return {closest.face, std::sqrt(closest.distance_sq)};
}

/// Both ways find the same, so the result doesn't depend on the order of the threads.
NearFace TargetSurface::nearest(const Vec3& point, Index hint) const {
  constexpr int most_without_tree = 16;  // a tree takes as long as about 60
  if (!has_tree_ && n_without_tree_++ < most_without_tree) return nearest_without_tree(point);
  build_tree(nullptr);
  if (!offsets_.empty()) {
    const auto [face, distance] = tree_->nearest_by_offsets(point, hint);
    return {face, distance};
  }
  const ClosestPoint closest = tree_->nearest_local(point, hint);
  return {closest.face, std::sqrt(closest.distance_sq)};
}

std::vector<Index> face_at_each_vertex(std::span<const Triangle> faces, std::size_t n_vertices) {
  std::vector<Index> at(n_vertices, invalid_index);
  for (Index f = 0; f < faces.size(); ++f) {
    for (const Index v : faces[f]) at[v] = f;
  }
  return at;
}

namespace {

/// Height over length below which rounding may move the closest point to another side.
constexpr double thin = 1e-3;

bool is_thin(const Corners& triangle) {
  const auto& [a, b, c] = triangle;
  const double longest_sq = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !(area_normal(a, b, c).squaredNorm() > thin * thin * longest_sq * longest_sq);
}

/// Distance of a point from a place inside of a thin triangle; infinite if the nearest one isn't inside. Along its
/// longest side and across it one after the other, as rounding errors along it are as large as the triangle is thin.
double distance_across(const Corners& triangle, const Vec3& point) {
  std::size_t longest = 0;
  double length_sq = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double square = (triangle[(i + 1) % 3] - triangle[i]).squaredNorm();
    if (square > length_sq) longest = i, length_sq = square;
  }
  const Vec3& from = triangle[longest];
  const Vec3 side = triangle[(longest + 1) % 3] - from;
  const Vec3 apex = triangle[(longest + 2) % 3] - from;
  const Vec3 to_point = point - from;
  const double apex_along = apex.dot(side) / length_sq;
  const double point_along = to_point.dot(side) / length_sq;
  const Vec3 height = apex - apex_along * side;
  const double across = (to_point - point_along * side).dot(height) / height.squaredNorm();
  const double along = point_along - across * apex_along;
  const bool is_inside = across >= 0 && along >= 0 && across + along <= 1;
  return is_inside ? (along * side + across * apex - to_point).norm() : std::numeric_limits<double>::infinity();
}

}  // namespace

double distance_to(const Corners& triangle, const Vec3& point) {
  const auto& [a, b, c] = triangle;
  if (!is_thin(triangle)) {
    const auto [second, third] = nearest_on_triangle(a - point, b - point, c - point);
    return (a + second * (b - a) + third * (c - a) - point).norm();
  }
  const auto to_side = [&point](const Vec3& from, const Vec3& to) {
    return (nearest_on_segment(point, from, to) - point).norm();
  };
  return std::min({distance_across(triangle, point), to_side(a, b), to_side(b, c), to_side(c, a)});
}

}  // namespace whittle
