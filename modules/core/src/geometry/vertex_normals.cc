#include "whittle/core/geometry/vertex_normals.hh"

#include <algorithm>
#include <span>
#include <utility>

#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

using Normal = std::array<float, 3>;

/// Zero stays zero.
Normal unit(Vec3 sum) {
  const double largest = sum.cwiseAbs().maxCoeff();
  if (largest > 0 && largest < 1e-140) sum /= largest;  // its square would lose digits
  const double length = sum.norm();
  if (length > 0) sum /= length;
  return {static_cast<float>(sum.x()), static_cast<float>(sum.y()), static_cast<float>(sum.z())};
}

Corners corners_in(const Frame& frame, const IndexedMesh& mesh, const Triangle& face) {
  return frame.to_frame(corners_of(mesh.positions, face));
}

/// Finds the corners, by the number 3f + c, that have one normal.
class SmoothCorners {
 public:
  /// \param directions of the faces, of any length; zero where a face has none
  SmoothCorners(std::span<const Triangle> faces, std::size_t n_vertices, std::span<const Vec3> directions,
                double crease_angle_deg)
      : faces_(faces), directions_(directions), sets_(3 * faces.size()) {
    // Tolerance for equal angles, as in a prism, whose coordinates were rounded to 32 bits.
    constexpr double rounding = 1e-6;
    least_cosine_ = detail::cosine_of_deg(crease_angle_deg) + rounding;
    const detail::EdgeTable edges(faces, n_vertices);
    for (std::size_t e = 0; e < edges.size(); ++e) join_at(edges.sides(e));
  }

  /// The least corner with the same normal.
  Index first_of(std::size_t corner) { return sets_.find(static_cast<Index>(corner)); }

 private:
  void join_at(std::span<const Index> sides) {
    // Where more faces meet at an edge, the file is faulty, and all pairs of them may be too many.
    constexpr std::size_t most_sides = 16;
    if (sides.size() > most_sides) return;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t k = i + 1; k < sides.size(); ++k) {
        if (is_smooth(detail::face_of(sides[i]), detail::face_of(sides[k]))) join(sides[i], sides[k]);
      }
    }
  }

  bool is_smooth(Index face, Index other) const {
    const double lengths = directions_[face].norm() * directions_[other].norm();
    return lengths > 0 && directions_[face].dot(directions_[other]) > least_cosine_ * lengths;
  }

  void join(Index side, Index other) {
    Index start = other;
    Index end = detail::next_in_face(other);
    if (detail::start_of(side, faces_) != detail::start_of(other, faces_)) std::swap(start, end);
    sets_.join(side, start);
    sets_.join(detail::next_in_face(side), end);
  }

  std::span<const Triangle> faces_;
  std::span<const Vec3> directions_;
  detail::DisjointSets<Index> sets_;
  double least_cosine_ = 1;
};

/// Normals by corner, 3f + c. \param of_vertices normals without creases
std::vector<Normal> corner_normals(const IndexedMesh& mesh, const Frame& frame, double crease_angle_deg,
                                   const std::vector<Normal>& of_vertices) {
  std::vector<Vec3> directions;
  directions.reserve(mesh.faces.size());
  for (const Triangle& face : mesh.faces) {
    const auto [a, b, c] = corners_in(frame, mesh, face);
    directions.push_back(reliable_normal(a, b, c));
  }
  SmoothCorners smooth(mesh.faces, mesh.positions.size(), directions, crease_angle_deg);
  std::vector<Vec3> sums(3 * mesh.faces.size(), Vec3::Zero());
  for (std::size_t corner = 0; corner < sums.size(); ++corner) {
    sums[smooth.first_of(corner)] += area_normal(corners_in(frame, mesh, mesh.faces[corner / 3]));
  }
  std::vector<Normal> normals(sums.size());
  for (std::size_t corner = 0; corner < sums.size(); ++corner) {
    const bool has_direction = !directions[corner / 3].isZero(0);
    normals[corner] =
        has_direction ? unit(sums[smooth.first_of(corner)]) : of_vertices[mesh.faces[corner / 3][corner % 3]];
  }
  return normals;
}

/// Gives each corner a wedge of its own, with the number of the corner. Normals are dropped.
void give_corners_wedges(IndexedMesh& mesh) {
  mesh.normals.clear();
  make_wedge_table(mesh);
  gather_wedges(mesh, mesh.wedges);
  for (std::size_t corner = 0; corner < mesh.wedges.size(); ++corner) mesh.wedges[corner] = static_cast<Index>(corner);
}

}  // namespace

std::vector<Normal> vertex_normals(const IndexedMesh& mesh, const Frame& frame) {
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  for (const Triangle& face : mesh.faces) {
    const Vec3 normal = area_normal(corners_in(frame, mesh, face));
    for (const Index v : face) sums[v] += normal;
  }
  std::vector<Normal> normals;
  normals.reserve(sums.size());
  for (const Vec3& sum : sums) normals.push_back(unit(sum));
  return normals;
}

void recompute_normals(IndexedMesh& mesh, const Frame& frame, double crease_angle_deg) {
  std::vector<Normal> of_vertices = vertex_normals(mesh, frame);
  const auto of_vertex = [&](std::size_t corner) { return of_vertices[mesh.faces[corner / 3][corner % 3]]; };
  std::vector<Normal> of_corners;
  if (crease_angle_deg < 180) of_corners = corner_normals(mesh, frame, crease_angle_deg, of_vertices);
  bool is_broken = false;
  for (std::size_t corner = 0; corner < of_corners.size() && !is_broken; ++corner) {
    is_broken = of_corners[corner] != of_vertex(corner);
  }
  if (!is_broken && mesh.wedges.empty()) {
    mesh.normals = std::move(of_vertices);
    return;
  }
  give_corners_wedges(mesh);
  mesh.normals = std::move(of_corners);
  for (std::size_t corner = mesh.normals.size(); corner < 3 * mesh.faces.size(); ++corner) {
    mesh.normals.push_back(of_vertex(corner));
  }
  join_equal_wedges(mesh);
}

}  // namespace whittle
