#include "guard/restraints.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace whittle {

Restraints::Restraints(const TriangleComplex& complex, std::span<const std::uint8_t> locked,
                       std::span<const VertexPair> features, double corner_angle_deg, double tolerance)
    : tolerance_sq_(tolerance * tolerance) {
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

/// The vertex of a feature edge that goes to the other's place.
Index Restraints::moved_vertex(const TriangleComplex& complex, const Pair& pair, const Vec3& position) const {
  const Pinned where = pinned(pair).value_or(Pinned::first);
  if (where == Pinned::second) return pair.a;  // even if both are in one place
  return where == Pinned::first || position == complex.position(pair.a) ? pair.b : pair.a;
}

/// The other feature edge of a vertex on a line.
std::optional<Index> Restraints::other_feature_edge(TriangleComplex& complex, Index v, Index edge) const {
  if (freedoms_[v] != Freedom::line) return std::nullopt;
  for (const Spoke& spoke : complex.live_pairs(v)) {
    const Index e = complex.live_edge(spoke.edge);
    if (e != edge && is_feature_[e]) return e;
  }
  return std::nullopt;
}

bool Restraints::bends_a_line(TriangleComplex& complex, const Pair& pair, const PairStar& star,
                              const Vec3& position) const {
  if (!has_features()) return false;
  const auto live_feature = [&](Index edge) { return is_feature_[complex.live_edge(edge)]; };
  const std::vector<PairStar::Opposite>& common = star.is_joint ? star.joint.common : star.opposites;
  const bool closes_loop = std::any_of(common.begin(), common.end(), [&](const PairStar::Opposite& neighbour) {
    return live_feature(neighbour.edges[0]) && live_feature(neighbour.edges[1]);
  });
  if (closes_loop) return true;
  if (!is_feature_[pair.id]) return false;
  // It takes its line's next edge along.
  const Index moved = moved_vertex(complex, pair, position);
  const std::optional<Index> next = other_feature_edge(complex, moved, pair.id);
  if (!next) return false;
  const auto [p, q] = complex.ends(*next);
  const Vec3& end = complex.position(p == moved ? q : p);
  const Vec3 way = end - position;
  const auto is_far = [&](const Vec3& point) {
    const Vec3 offset = point - position;
    const double share = way.squaredNorm() > 0 ? std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
    return (offset - share * way).squaredNorm() > tolerance_sq_;
  };
  if (is_far(complex.position(moved))) return true;
  for (const Index edge : {pair.id, *next}) {
    const auto course = courses_.find(edge);
    if (course != courses_.end() && std::any_of(course->second.begin(), course->second.end(), is_far)) return true;
  }
  return false;
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

void Restraints::contract(TriangleComplex& complex, const Pair& pair, Index survivor, const PairStar& star,
                          const Vec3& position) {
  if (!any()) return;
  if (is_feature(pair.id)) {
    const Index moved = moved_vertex(complex, pair, position);
    Course course = std::move(courses_[pair.id]);
    courses_.erase(pair.id);
    if (const std::optional<Index> next = other_feature_edge(complex, moved, pair.id)) {
      Course& whole = courses_[*next];
      whole.push_back(complex.position(moved));
      whole.insert(whole.end(), course.begin(), course.end());
    }
  }
  freedoms_[survivor] = std::max(freedoms_[pair.a], freedoms_[pair.b]);
  if (!has_features()) return;
  const auto merge = [&](const PairStar::Opposite& opposite) {
    const Index first = complex.live_edge(opposite.edges[0]);
    const Index second = complex.live_edge(opposite.edges[1]);
    const bool either = is_feature_[first] || is_feature_[second];
    for (const auto& [from, to] : {std::pair(first, second), std::pair(second, first)}) {
      if (is_feature_[from] && !is_feature_[to] && courses_.contains(from)) courses_[to] = courses_[from];
    }
    is_feature_[first] = is_feature_[second] = either;
  };
  std::for_each(star.opposites.begin(), star.opposites.end(), merge);
  if (star.is_joint) std::for_each(star.joint.common.begin(), star.joint.common.end(), merge);
}

}  // namespace whittle
