#include "guard/displacement_guard.hh"

#include <algorithm>
#include <cmath>

#include "whittle/core/geometry/triangle.hh"

namespace whittle {
namespace {

/// Between two normals: 1 if one is zero.
double cosine_between(const Vec3& normal, const Vec3& other) {
  const double lengths = normal.norm() * other.norm();
  return lengths > 0 ? normal.dot(other) / lengths : 1;
}

}  // namespace

DisplacementGuard::DisplacementGuard(const TriangleComplex& complex, double limit, std::span<const double> limits)
    : complex_(complex), limit_sq_(limit * limit) {
  if (limits.empty()) return;
  limits_.reserve(complex.n_vertex_slots());
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) limits_.push_back(limits[complex.origin(v)]);
}

void DisplacementGuard::note(const Change& change) {
  limits_[change.survivor] = std::min(limits_[change.survivor], limits_[change.removed]);
}

bool DisplacementGuard::refuses_at(ContractionProfile& profile, const Vec3& position) {
  if (!limits_.empty()) {
    const double limit = std::min(limits_[profile.pair.a], limits_[profile.pair.b]);
    limit_sq_ = limit * limit;
  }
  const auto [displacement_sq, least_cosine] = motion(profile, position);
  if (displacement_sq > limit_sq_) return true;
  double longest_sq = 0;
  for (const StarFaces& faces : {profile.first, profile.second}) {
    for (const Neighbour& neighbour : faces.neighbours()) {
      longest_sq = std::max(longest_sq, (complex_.position(neighbour.vertex) - position).squaredNorm());
    }
  }
  const double cosine = std::max(0.0, least_cosine);
  if (share_of_turn * share_of_turn * longest_sq * (1 - cosine * cosine) > limit_sq_) return true;
  const auto& [id, a, b] = profile.pair;
  const bool has_border = complex_.kind(a) != VertexKind::regular || complex_.kind(b) != VertexKind::regular;
  return has_border && moves_border(profile, position);
}

bool DisplacementGuard::moves_border(const ContractionProfile& profile, const Vec3& position) {
  const std::array<const StarFaces*, 2> stars{&profile.first, &profile.second};
  for (std::size_t end = 0; end < 2; ++end) {
    others_[end].clear();
    for (std::size_t i = 0; i < stars[end]->size(); ++i) others_[end].push_back((*stars[end])[i]);
  }
  opposites_.clear();
  for (const ContractionProfile::Common& opposite : profile.opposites) opposites_.push_back(opposite.vertex);
  return border_motion_.exceeds(
      {profile.pair.a, profile.pair.b}, {{others_[0], others_[1]}, opposites_},
      [this](Index v) { return complex_.position(v); }, position, std::sqrt(limit_sq_));
}

DisplacementGuard::Motion DisplacementGuard::motion(ContractionProfile& profile, const Vec3& position) {
  if (profile.has_ring && profile.ring.moved_to() == position) {
    return {profile.ring.displacement_sq(position), std::min(1.0, profile.ring.least_cosine())};
  }
  const auto& [id, a, b] = profile.pair;
  const std::array<Vec3, 2> ends{complex_.position(a), complex_.position(b)};
  before_.clear();
  after_.clear();
  double least_cosine = 1;
  for (std::size_t end = 0; end < 2; ++end) {
    const StarFaces& faces = end == 0 ? profile.first : profile.second;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Vec3& x = complex_.position(faces[i].x);
      const Vec3& y = complex_.position(faces[i].y);
      before_.push_back({ends[end], x, y});
      after_.push_back({position, x, y});
      least_cosine =
          std::min(least_cosine, cosine_between(reliable_normal(ends[end], x, y), reliable_normal(position, x, y)));
    }
  }
  for (const ContractionProfile::Common& opposite : profile.opposites) {
    before_.push_back({ends[0], ends[1], complex_.position(opposite.vertex)});
  }
  const double displacement = std::max({distance_to_nearest(before_, position), distance_to_nearest(after_, ends[0]),
                                        distance_to_nearest(after_, ends[1])});
  return {displacement * displacement, least_cosine};
}

}  // namespace whittle
