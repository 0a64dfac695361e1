#include "oracle/brute_force_memoryless.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "support/face_list.hh"
#include "whittle/core/geometry/nearest_on_triangle.hh"

namespace whittle::test {
namespace {

/// The corner after x in the face (v, x, …).
Index corner_after(std::span<const Triangle> faces, Index v, Index x) {
  for (const Triangle& f : faces) {
    if (has(f, v) && f[(corner_of(f, v) + 1) % 3] == x) return f[(corner_of(f, v) + 2) % 3];
  }
  return invalid_index;
}

/// Whether the faces at v are one closed fan of one orientation.
bool is_ring(Index v, std::span<const Triangle> faces) {
  const Link link = link_of(v, faces);
  if (link.edges.empty() || link.vertices.contains(invalid_index)) return false;
  return std::ranges::all_of(link.vertices, [&](Index x) { return corner_after(faces, v, x) != invalid_index; });
}

/// The faces at v or w.
std::set<Index> neighbours_of(Index a, Index b, std::span<const Triangle> faces) {
  std::set<Index> vertices;
  for (const Triangle& f : faces) {
    if (has(f, a) || has(f, b)) vertices.insert(f.begin(), f.end());
  }
  vertices.erase(a);
  vertices.erase(b);
  return vertices;
}

bool is_neighbour(Index v, Index w, std::span<const Triangle> faces) {
  return std::ranges::any_of(faces, [=](const Triangle& f) { return has(f, v) && has(f, w); });
}

template <class T>
T sum_of_four(const std::array<T, 4>& sums) {
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

PointLanes<double> normal_of(const std::array<Vec3, 3>& corners) {
  const PointLanes<double> apex = point_lanes(corners[0]);
  return (point_lanes(corners[1]) - apex).cross(point_lanes(corners[2]) - apex);
}

SymmetricMatrix plane_of(const std::array<Vec3, 3>& corners, const QuadricOptions& options) {
  return corner_quadric(corners[0], corners[1], corners[2], options);
}

}  // namespace

FacesAroundPair::FacesAroundPair(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                                 const Vec3& origin) {
  const auto at = [&](Index v) -> Vec3 { return positions[v] - origin; };
  const Index first_wing = corner_after(faces, a, b);
  Index second_wing = first_wing;
  for (Index next = first_wing; next != b; next = corner_after(faces, a, second_wing)) {
    if (next != first_wing) faces_.push_back({at(a), at(second_wing), at(next)});
    second_wing = next;
  }
  for (Index x = second_wing; x != first_wing;) {
    const Index next = corner_after(faces, b, x);
    faces_.push_back({at(b), at(x), at(next)});
    x = next;
  }
  common_ = {Corners{at(a), at(b), at(first_wing)}, Corners{at(a), at(second_wing), at(b)}};
}

StarVolume FacesAroundPair::volume() const {
  struct Sum {
    PointLanes<double> normal{};
    double offset = 0, length = 0;
    Sum operator+(const Sum& o) const { return {normal + o.normal, offset + o.offset, length + o.length}; }
  };
  std::array<Sum, 4> sums;
  const auto add = [&](std::size_t i, const Corners& face) {
    const PointLanes<double> normal = normal_of(face);
    const Sum one{normal, normal.dot(point_lanes(face[0])), std::sqrt(normal.dot(normal))};
    sums[i % 4] = sums[i % 4] + one;
  };
  double farthest_sq = 0;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    add(i, faces_[i]);
    const PointLanes<double> neighbour = point_lanes(faces_[i][1]);
    farthest_sq = std::max(farthest_sq, neighbour.dot(neighbour));
  }
  add(0, common_[0]);
  add(1, common_[1]);
  const auto [normal, offset, length] = sum_of_four(sums);
  return {{normal.x, normal.y, normal.z}, offset, length, farthest_sq};
}

double FacesAroundPair::displacement_sq(const Vec3& apex) const {
  const auto nearest_sq = [](const Vec3& p, const std::vector<Corners>& faces) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [x, y, z] : faces) least = std::min(least, distance_sq_to_triangle(x - p, y - p, z - p));
    return least;
  };
  std::vector<Corners> before = faces_;
  before.insert(before.end(), common_.begin(), common_.end());
  std::vector<Corners> after = faces_;
  for (Corners& face : after) face[0] = apex;
  const Vec3& a = common_[0][0];
  const Vec3& b = common_[0][1];
  return std::max({nearest_sq(apex, before), nearest_sq(a, after), nearest_sq(b, after)});
}

SymmetricMatrix FacesAroundPair::planes(const Vec3& apex, const QuadricOptions& options) const {
  std::array<SymmetricMatrix, 4> sums;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    sums[i % 4] += plane_of({apex, faces_[i][1], faces_[i][2]}, options);
  }
  return sum_of_four(sums);
}

SymmetricMatrix change_of_planes(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a, Index b,
                                 Index v, const Vec3& position, const Vec3& origin, const QuadricOptions& options) {
  const auto plane = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return corner_quadric(p - origin, q - origin, r - origin, options);
  };
  SymmetricMatrix gain;
  SymmetricMatrix loss;
  for (const Triangle& f : faces) {
    if (!has(f, v)) continue;
    if (has(f, a) && has(f, b)) {
      loss += plane(positions[a], positions[b], positions[v]);
    } else if (has(f, a) || has(f, b)) {
      const std::size_t corner = corner_of(f, has(f, a) ? a : b);
      const Vec3& x = positions[f[(corner + 1) % 3]];
      const Vec3& y = positions[f[(corner + 2) % 3]];
      SymmetricMatrix change = plane(position, x, y);
      change -= plane(positions[f[corner]], x, y);
      gain += change;
    }
  }
  gain -= loss;
  return gain;
}

BruteForceMemory::BruteForceMemory(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                   const std::vector<bool>& is_on_seam)
    : remembers_(positions.size()) {
  for (Index v = 0; v < positions.size(); ++v) is_ring_.push_back(is_ring(v, faces));
  double area = 0;
  std::size_t n_corners = 0;
  for (const Triangle& f : faces) {
    const auto n_inside =
        static_cast<std::size_t>(std::ranges::count_if(f, [&](Index v) { return is_ring_[v] && !is_on_seam[v]; }));
    const Vec3 normal = (positions[f[1]] - positions[f[0]]).cross(positions[f[2]] - positions[f[0]]);
    area += 0.5 * normal.norm() * static_cast<double>(n_inside);
    n_corners += n_inside;
  }
  face_area_ = {area, n_corners, faces.size()};
}

std::vector<Index> BruteForceMemory::forgetful_neighbours(Index a, Index b, bool is_nonmanifold,
                                                          std::span<const Triangle> faces) const {
  std::vector<Index> result;
  if (is_nonmanifold) return result;
  for (const Index v : neighbours_of(a, b, faces)) {
    if (is_ring_[v] && !remembers_[v]) result.push_back(v);
  }
  return result;
}

void BruteForceMemory::contract(Index survivor, Index removed, bool is_nonmanifold, std::span<const Triangle> before,
                                std::span<const Triangle> after) {
  remembers_[survivor] = !forgets(survivor, removed, is_nonmanifold);
  is_ring_[survivor] = is_ring_[survivor] && is_ring_[removed];
  if (!is_nonmanifold) return;
  is_ring_[survivor] = is_ring(survivor, after);
  for (const Index v : neighbours_of(survivor, removed, before)) {
    remembers_[v] = true;
    if (is_neighbour(v, survivor, before) && is_neighbour(v, removed, before)) is_ring_[v] = is_ring(v, after);
  }
}

}  // namespace whittle::test
