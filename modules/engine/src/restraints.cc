#include "restraints.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace whittle {

Restraints::Restraints(const TriangleComplex& complex, std::span<const std::uint8_t> locked,
                       std::span<const VertexPair> features, double corner_angle_deg) {
  if (locked.empty() && features.empty()) return;
  freedoms_.assign(complex.n_vertex_slots(), Freedom::full);
  if (!features.empty()) mark_features(complex, features, corner_angle_deg);
  for (Index v = 0; v < locked.size(); ++v) {
    if (locked[v] != 0) freedoms_[v] = Freedom::locked;
  }
}

void Restraints::mark_features(const TriangleComplex& complex, std::span<const VertexPair> features,
                               double corner_angle_deg) {
  is_feature_.resize(complex.n_pair_slots());
  std::vector<std::array<Index, 2>> others(complex.n_vertex_slots());  // of the first two feature edges at a vertex
  std::vector<Index> n_features(complex.n_vertex_slots());
  const auto add = [&](Index v, Index other) {
    if (n_features[v] < 2) others[v][n_features[v]] = other;
    ++n_features[v];
  };
  for (Index e = 0; e < complex.n_edges(); ++e) {
    const auto [a, b] = complex.initial_ends(e);
    const std::pair<Index, Index> origins = std::minmax({complex.origin(a), complex.origin(b)});
    if (!std::binary_search(features.begin(), features.end(), VertexPair{origins.first, origins.second})) continue;
    is_feature_[e] = true;
    add(a, b);
    add(b, a);
  }
  const double least_cosine = std::cos(corner_angle_deg * std::numbers::pi / 180);
  const auto turns = [&](Index v) {
    const Vec3 in = complex.position(v) - complex.position(others[v][0]);
    const Vec3 out = complex.position(others[v][1]) - complex.position(v);
    return in.dot(out) < least_cosine * in.norm() * out.norm();
  };
  for (Index v = 0; v < freedoms_.size(); ++v) {
    if (n_features[v] == 0) continue;
    freedoms_[v] = n_features[v] == 2 && !turns(v) ? Freedom::line : Freedom::corner;
  }
}

bool Restraints::closes_feature_loop(const TriangleComplex& complex, const PairStar& star) const {
  if (!has_features()) return false;
  const auto is_feature = [&](Index edge) { return is_feature_[complex.live_edge(edge)]; };
  return std::any_of(star.opposites.begin(), star.opposites.end(), [&](const PairStar::Opposite& opposite) {
    return is_feature(opposite.edges[0]) && is_feature(opposite.edges[1]);
  });
}

std::vector<VertexPair> Restraints::feature_edges(TriangleComplex& complex) const {
  std::vector<VertexPair> edges;
  for (Index e = 0; e < is_feature_.size(); ++e) {
    if (!is_feature_[e] || !complex.is_pair_alive(e)) continue;
    const auto [a, b] = complex.ends(e);
    edges.push_back({a, b});
  }
  return edges;
}

void Restraints::contract(const TriangleComplex& complex, Index survivor, Index removed, const PairStar& star) {
  if (!any()) return;
  freedoms_[survivor] = std::max(freedoms_[survivor], freedoms_[removed]);
  if (!has_features()) return;
  const auto merge = [&](const PairStar::Opposite& opposite) {
    const Index first = complex.live_edge(opposite.edges[0]);
    const Index second = complex.live_edge(opposite.edges[1]);
    const bool either = is_feature_[first] || is_feature_[second];
    is_feature_[first] = is_feature_[second] = either;
  };
  std::for_each(star.opposites.begin(), star.opposites.end(), merge);
  if (star.is_joint) std::for_each(star.joint.common.begin(), star.joint.common.end(), merge);
}

}  // namespace whittle
