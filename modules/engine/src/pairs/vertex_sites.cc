#include "pairs/vertex_sites.hh"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/geometry/space_filling_curve.hh"

namespace whittle {
namespace {

/// The numbers of the vertices in faces, ascending.
std::vector<Index> vertices_in_faces(std::size_t n_vertices, std::span<const Triangle> faces) {
  std::vector<char> is_used(n_vertices, 0);
  check_corners(n_vertices, faces);
  for (const Triangle& face : faces) {
    if (!has_three_corners(face)) continue;
    for (const Index v : face) is_used[v] = 1;
  }
  std::vector<Index> vertices;
  vertices.reserve(n_vertices);
  for (Index v = 0; v < n_vertices; ++v) {
    if (is_used[v] != 0) vertices.push_back(v);
  }
  return vertices;
}

/// Sorted along the curve; within a cell of the curve by position, at one position by number.
std::vector<CurvePoint> sorted_by_site(std::span<const Vec3> positions, const Frame& frame, unsigned threads) {
  std::vector<CurvePoint> points = along_morton_curve(positions, frame, threads);
  const auto precedes = [&](const CurvePoint& a, const CurvePoint& b) {
    const Vec3& p = positions[a.number];
    const Vec3& q = positions[b.number];
    return std::tie(p.x(), p.y(), p.z(), a.number) < std::tie(q.x(), q.y(), q.z(), b.number);
  };
  for (auto begin = points.begin(); begin != points.end();) {
    const auto end = std::find_if(begin, points.end(), [&](const CurvePoint& p) { return p.cell != begin->cell; });
    if (end - begin > 1) std::sort(begin, end, precedes);
    begin = end;
  }
  return points;
}

}  // namespace

VertexSites make_vertex_sites(std::span<const Vec3> positions, std::span<const Triangle> faces, unsigned threads) {
  const std::vector<Index> used = vertices_in_faces(positions.size(), faces);
  std::vector<Vec3> used_positions;
  used_positions.reserve(used.size());
  for (const Index v : used) {
    if (!positions[v].allFinite()) {
      throw std::invalid_argument("vertex " + std::to_string(v) + " has a coordinate that is not finite");
    }
    used_positions.push_back(positions[v]);
  }
  VertexSites result;
  result.frame = Frame::of_points(used_positions);
  result.members.assign(positions.size(), invalid_index);
  result.points.reserve(used.size());
  result.begins.reserve(used.size() + 1);
  result.sites.reserve(used.size());
  result.vertices.reserve(used.size());
  for (const auto& [cell, i] : sorted_by_site(used_positions, result.frame, threads)) {
    const auto member = static_cast<Index>(result.vertices.size());
    const Vec3 point = result.frame.to_frame(used_positions[i]);
    if (member == 0 || point != result.points.back()) {
      result.points.push_back(point);
      result.begins.push_back(member);
    }
    result.members[used[i]] = member;
    result.vertices.push_back(used[i]);
    result.sites.push_back(static_cast<Index>(result.points.size() - 1));
  }
  result.begins.push_back(static_cast<Index>(used.size()));
  return result;
}

}  // namespace whittle
