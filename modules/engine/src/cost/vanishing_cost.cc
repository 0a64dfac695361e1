#include "cost/vanishing_cost.hh"

#include <algorithm>

#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {
namespace {

double cost_of_face(const Corners& corners, double dimension) {
  const auto& [a, b, c] = corners;
  const double longest_sq = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  const double area = 0.5 * area_normal(a, b, c).norm();
  return area > 0 ? area * detail::power(longest_sq, 0.5 * dimension - 1) : 0;
}

/// Calls `is_wanted(face)` for the faces at the merged vertex, until one is.
template <class IsWanted>
bool is_any_left(const ContractionProfile& profile, const IsWanted& is_wanted) {
  for (const StarFaces& star : {profile.first, profile.second}) {
    for (std::size_t i = 0; i < star.size(); ++i) {
      if (is_wanted(star[i])) return true;
    }
  }
  return false;
}

}  // namespace

double vanishing_cost(const TriangleComplex& complex, const ContractionProfile& profile, const Vec3& position,
                      double dimension) {
  if (!profile.is_nonmanifold || complex.is_threshold_pair(profile.pair.id)) return 0;
  double cost = 0;
  for (const auto& [x, y] : profile.nonmanifold.coincident) {
    const auto covers = [x = x, y = y](const LinkEdge& face) {
      return (face.x == x && face.y == y) || (face.x == y && face.y == x);
    };
    if (is_any_left(profile, covers)) continue;
    cost += cost_of_face({position, complex.position(x), complex.position(y)}, dimension);
  }
  for (const ContractionProfile::Common& opposite : profile.opposites) {
    const auto hangs_on = [v = opposite.vertex](const LinkEdge& face) { return face.x == v || face.y == v; };
    if (is_any_left(profile, hangs_on)) continue;
    const auto& [id, a, b] = profile.pair;
    cost += cost_of_face({complex.position(a), complex.position(b), complex.position(opposite.vertex)}, dimension);
  }
  return cost;
}

}  // namespace whittle
