#include "oracle/point_distance.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace whittle::test {

long double distance_by_features(const LongVec3& p, const LongVec3& a, const LongVec3& b, const LongVec3& c) {
  long double best_sq = std::min({(p - a).squaredNorm(), (p - b).squaredNorm(), (p - c).squaredNorm()});
  const auto side = [&](const LongVec3& from, const LongVec3& to) {
    const LongVec3 along = to - from;
    const long double t = along.dot(p - from) / along.squaredNorm();
    if (t > 0 && t < 1) best_sq = std::min(best_sq, (p - from - t * along).squaredNorm());
  };
  side(a, b), side(b, c), side(c, a);
  // Barycentric coordinates of the foot. One side is made orthogonal to the other: the normal equations are wrong by
  // 1e-7 on needles.
  const LongVec3 u = b - a, v = c - a, w = p - a;
  const LongVec3 across = v - v.dot(u) / u.squaredNorm() * u;
  const long double t = across.dot(w) / across.squaredNorm();
  const long double s = u.dot(w - t * v) / u.squaredNorm();
  if (s > 0 && t > 0 && s + t < 1) best_sq = std::min(best_sq, (w - s * u - t * v).squaredNorm());
  return std::sqrt(best_sq);
}

long double distance_by_features(const IndexedMesh& mesh, const Vec3& point) {
  long double best = std::numeric_limits<long double>::infinity();
  for (const auto& [a, b, c] : mesh.faces) {
    best = std::min(best,
                    distance_by_features(point.cast<long double>(), mesh.positions[a].cast<long double>(),
                                         mesh.positions[b].cast<long double>(), mesh.positions[c].cast<long double>()));
  }
  return best;
}

}  // namespace whittle::test
