#include "guard/face_limits.hh"

#include <cmath>
#include <limits>
#include <numbers>

namespace whittle {

FaceLimits::FaceLimits(const FaceNeighbors& neighbors, std::span<const VertexPair> features, double feature_angle_deg,
                       double min_radius_ratio)
    : neighbors_(neighbors),
      least_cosine_(least_fold_cosine),
      min_radius_ratio_(std::max(min_radius_ratio, least_radius_ratio)),
      wide_(min_radius_ratio_ > least_radius_ratio ? std::numeric_limits<double>::infinity() : 0.05) {
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

}  // namespace whittle
