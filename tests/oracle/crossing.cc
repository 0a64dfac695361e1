#include "oracle/crossing.hh"

#include <Eigen/Geometry>
#include <algorithm>

#include "oracle/point_distance.hh"

namespace whittle::test {
namespace {

using Corners = std::array<LongVec3, 3>;

/// Of the sides of this triangle's volumes a share below that may be rounding.
constexpr long double margin = 1e-6L;

/// 1 or −1 if d is clearly on one side of the plane through a, b and c, else 0.
int side_of(const LongVec3& a, const LongVec3& b, const LongVec3& c, const LongVec3& d) {
  const LongVec3 u = b - a;
  const LongVec3 v = c - a;
  const LongVec3 w = d - a;
  const long double share = u.cross(v).dot(w) / (u.norm() * v.norm() * w.norm());
  return share > margin ? 1 : share < -margin ? -1 : 0;
}

bool pierces(const LongVec3& from, const LongVec3& to, const Corners& t) {
  const int below = side_of(t[0], t[1], t[2], from);
  if (below == 0 || side_of(t[0], t[1], t[2], to) != -below) return false;
  const int first = side_of(from, to, t[0], t[1]);
  return first != 0 && side_of(from, to, t[1], t[2]) == first && side_of(from, to, t[2], t[0]) == first;
}

/// Whether a triangle is clearly more than a line.
bool has_area(const Corners& t) {
  const LongVec3 u = t[1] - t[0];
  const LongVec3 v = t[2] - t[0];
  return u.cross(v).norm() > margin * u.norm() * v.norm();
}

bool cross(const Corners& s, const Corners& t) {
  if (!has_area(s) || !has_area(t)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (pierces(s[i], s[(i + 1) % 3], t) || pierces(t[i], t[(i + 1) % 3], s)) return true;
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
