#include "guard/face_limits.hh"

#include <limits>

#include "whittle/core/detail/portable_math.hh"

namespace whittle::polishing {

FaceLimits::FaceLimits(const FaceNeighbors& neighbors, std::span<const VertexPair> features,
                       std::optional<double> feature_angle_deg, double min_radius_ratio)
    : neighbors_(neighbors),
      least_cosine_(least_fold_cosine),
      min_radius_ratio_(std::max(min_radius_ratio, least_radius_ratio)),
      wide_(min_radius_ratio_ > least_radius_ratio ? std::numeric_limits<double>::infinity() : 0.05) {
  if (!feature_angle_deg) return;
  least_cosine_ = detail::cosine_of_deg(*feature_angle_deg);
  is_feature_.resize(neighbors.n_faces());
  for (const auto& [a, b] : features) {
    const auto [face, slot] = neighbors.inner_side(a, b);
    if (face == invalid_index) continue;
    const auto [other, other_slot] = neighbors.beyond(face, slot);
    is_feature_[face][slot] = is_feature_[other][other_slot] = true;
  }
}

}  // namespace whittle::polishing
