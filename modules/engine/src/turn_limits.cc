#include "turn_limits.hh"

#include <cmath>
#include <numbers>

namespace whittle {

TurnLimits::TurnLimits(const FaceNeighbors& neighbors, std::span<const VertexPair> features, double feature_angle_deg)
    : neighbors_(neighbors), least_cosine_(least_fold_cosine) {
  if (!(feature_angle_deg < 180)) return;
  least_cosine_ = std::cos(feature_angle_deg * std::numbers::pi / 180);
  is_feature_.resize(neighbors.n_faces());
  for (const auto& [a, b] : features) {
    const auto [face, place] = neighbors.inner_side(a, b);
    if (face == invalid_index) continue;
    const auto [other, other_place] = neighbors.beyond(face, place);
    is_feature_[face][place] = is_feature_[other][other_place] = true;
  }
}

double TurnLimits::cosine(Index face, Index place, const Vec3& normal, const Vec3& other) const {
  const double cosine = normal.dot(other) / std::sqrt(normal.squaredNorm() * other.squaredNorm());
  return neighbors_.is_twisted(face, place) ? -cosine : cosine;
}

}  // namespace whittle
