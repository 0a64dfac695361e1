#include "oracle/crossing.hh"

#include <Eigen/Geometry>
#include <algorithm>

#include "oracle/point_distance.hh"

namespace whittle::test {
namespace {

using Corners = std::array<LongVec3, 3>;

/// Of the sides of this triangle's volumes a share below that may be rounding.
constexpr long double margin = 1e-6L;

/// Triangles that enter each other by a share of their size below that touch. Ten times what the guards against
/// intersections let pass.
constexpr long double touching = 1e-11L;

/// The sign of a volume that is clearly above both limits, else 0.
int clear_sign(long double volume, long double limit, long double other_limit) {
  const long double least = std::max(limit, other_limit);
  return volume > least ? 1 : volume < -least ? -1 : 0;
}

/// 1 or −1 if p is clearly on one side of the triangle's plane, else 0. \param least the least height
int side_of_plane(const Corners& t, const LongVec3& p, long double least) {
  const LongVec3 u = t[1] - t[0];
  const LongVec3 v = t[2] - t[0];
  const LongVec3 w = p - t[0];
  const LongVec3 normal = u.cross(v);
  return clear_sign(normal.dot(w), margin * u.norm() * v.norm() * w.norm(), least * normal.norm());
}

/// 1 or −1 if the line through a and b clearly passes the line through p and q on one side, else 0. \param least the
/// least distance of the lines
int side_of_line(const LongVec3& p, const LongVec3& q, const LongVec3& a, const LongVec3& b, long double least) {
  const LongVec3 u = q - p;
  const LongVec3 v = a - p;
  const LongVec3 w = b - p;
  return clear_sign(u.cross(v).dot(w), margin * u.norm() * v.norm() * w.norm(), least * u.cross(b - a).norm());
}

/// \param least the triangle would have to be moved farther than that not to be pierced
bool pierces(const LongVec3& from, const LongVec3& to, const Corners& t, long double least) {
  const int below = side_of_plane(t, from, least);
  if (below == 0 || side_of_plane(t, to, least) != -below) return false;
  const auto side = [&](std::size_t i) { return side_of_line(from, to, t[i], t[(i + 1) % 3], least); };
  return side(0) != 0 && side(1) == side(0) && side(2) == side(0);
}

/// Whether a triangle is clearly more than a line.
bool has_area(const Corners& t) {
  const LongVec3 u = t[1] - t[0];
  const LongVec3 v = t[2] - t[0];
  return u.cross(v).norm() > margin * u.norm() * v.norm();
}

bool cross(const Corners& s, const Corners& t) {
  if (!has_area(s) || !has_area(t)) return false;
  long double size = 0;
  for (const LongVec3& p : {s[1], s[2], t[0], t[1], t[2]}) size = std::max(size, (p - s[0]).norm());
  const long double least = touching * size;
  for (std::size_t i = 0; i < 3; ++i) {
    if (pierces(s[i], s[(i + 1) % 3], t, least) || pierces(t[i], t[(i + 1) % 3], s, least)) return true;
  }
  return false;
}

}  // namespace

std::vector<std::array<Index, 2>> clear_crossings(const IndexedMesh& mesh) {
  const auto corners = [&mesh](const Triangle& f) {
    Corners result;
    for (std::size_t i = 0; i < 3; ++i) result[i] = mesh.positions[f[i]].cast<long double>();
    return result;
  };
  std::vector<std::array<Index, 2>> pairs;
  for (Index g = 0; g < mesh.faces.size(); ++g) {
    for (Index f = 0; f < g; ++f) {
      const Triangle& other = mesh.faces[g];
      const auto n_common = std::count_if(mesh.faces[f].begin(), mesh.faces[f].end(), [&other](Index v) {
        return std::find(other.begin(), other.end(), v) != other.end();
      });
      if (n_common < 2 && cross(corners(mesh.faces[f]), corners(other))) pairs.push_back({f, g});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace whittle::test
