#include "complex/constraints.hh"

#include <algorithm>
#include <array>

#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/geometry/segment.hh"

namespace whittle {

Constraints::Constraints(const TriangleComplex& complex, std::span<const std::uint8_t> locked,
                         const FeatureLines& lines, double corner_angle_deg, double tolerance, SeamHold seam_hold)
    : tolerance_sq_(tolerance * tolerance), seam_hold_(seam_hold) {
  if (locked.empty() && lines.edges.empty()) return;
  constraints_.assign(complex.n_vertex_slots(), Constraint::free);
  if (!lines.edges.empty()) mark_features(complex, lines, corner_angle_deg);
  for (Index v = 0; v < locked.size(); ++v) {
    if (locked[v] != 0) constraints_[v] = Constraint::locked;
  }
}

void Constraints::mark_features(const TriangleComplex& complex, const FeatureLines& lines, double corner_angle_deg) {
  is_feature_.resize(complex.n_pair_slots());
  if (!lines.is_seam.empty()) is_seam_.resize(complex.n_pair_slots());
  struct Other {
    Index vertex;
    bool is_seam;
  };
  std::vector<std::array<Other, 2>> others(complex.n_vertex_slots());  // of the first two feature edges at a vertex
  std::vector<Index> n_features(complex.n_vertex_slots());
  const auto add = [&](Index v, const Other& other) {
    if (n_features[v] < 2) others[v][n_features[v]] = other;
    ++n_features[v];
  };
  for (Index e = 0; e < complex.n_edges(); ++e) {
    const auto [a, b] = complex.initial_ends(e);
    const auto [low, high] = std::minmax({complex.origin(a), complex.origin(b)});
    const VertexPair ends{low, high};
    const auto found = std::lower_bound(lines.edges.begin(), lines.edges.end(), ends);
    if (found == lines.edges.end() || *found != ends) continue;
    is_feature_[e] = true;
    const auto number = static_cast<std::size_t>(found - lines.edges.begin());
    if (!lines.courses.empty() && !lines.courses[number].empty()) courses_[e] = lines.courses[number];
    if (!lines.is_seam.empty()) is_seam_[e] = lines.is_seam[number] != 0;
    add(a, {b, is_seam(e)});
    add(b, {a, is_seam(e)});
  }
  const double least_cosine = detail::cosine_of_deg(corner_angle_deg);
  const auto turns = [&](Index v) {
    const auto& [first, second] = others[v];
    if (first.is_seam != second.is_seam) return true;
    if (first.is_seam) return false;
    const Vec3 in = complex.position(v) - complex.position(first.vertex);
    const Vec3 out = complex.position(second.vertex) - complex.position(v);
    return in.dot(out) < least_cosine * in.norm() * out.norm();
  };
  std::vector<bool> is_corner(constraints_.size());  // by original vertex
  for (const Index v : lines.corners.value_or(std::vector<Index>{})) is_corner[v] = true;
  for (Index v = 0; v < constraints_.size(); ++v) {
    if (n_features[v] == 0) continue;
    const bool is_on_line = n_features[v] == 2 && !(lines.corners ? is_corner[complex.origin(v)] : turns(v));
    constraints_[v] = is_on_line ? Constraint::on_line : Constraint::at_corner;
  }
}

/// Of a feature edge, the end that goes to the other's place: 0 or 1. \param first position of the first end
std::size_t Constraints::moved_end(const Pair& pair, const Vec3& first, const Vec3& position) const {
  const PairConstraint where = of(pair).value_or(PairConstraint::first);
  if (where == PairConstraint::second) return 0;  // even if both are in one place
  return where == PairConstraint::first || position == first ? 1 : 0;
}

/// The other feature edge of a vertex on a line.
std::optional<Index> Constraints::other_feature_edge(TriangleComplex& complex, Index v, Index edge) const {
  if (constraints_[v] != Constraint::on_line) return std::nullopt;
  for (const Neighbour& neighbour : complex.live_pairs(v)) {
    const Index e = complex.live_edge(neighbour.edge);
    if (e != edge && is_feature_[e]) return e;
  }
  return std::nullopt;
}

/// Whether a non-manifold contraction takes all faces of a feature edge away.
bool Constraints::takes_a_line_away(TriangleComplex& complex, const ContractionProfile& profile) const {
  if (!profile.is_nonmanifold) return false;
  const auto is_live_line = [&](Index edge) { return is_feature_[complex.live_edge(edge)]; };
  const std::vector<Index>& lost = profile.nonmanifold.lost_edges;
  if (std::any_of(lost.begin(), lost.end(), is_live_line)) return true;
  // Of two edges that become one, the first is listed.
  const std::vector<ContractionProfile::Common>& common = profile.nonmanifold.common;
  return std::any_of(common.begin(), common.end(), [&](const ContractionProfile::Common& neighbour) {
    return is_live_line(neighbour.edges[1]) && std::find(lost.begin(), lost.end(), neighbour.edges[0]) != lost.end();
  });
}

bool Constraints::harms_a_line(TriangleComplex& complex, const ContractionProfile& profile,
                               const Vec3& position) const {
  if (!has_features()) return false;
  const Pair& pair = profile.pair;
  const auto is_live_line = [&](Index edge) { return is_feature_[complex.live_edge(edge)]; };
  const std::vector<ContractionProfile::Common>& common = profile.merged_neighbours();
  const bool closes_loop = std::any_of(common.begin(), common.end(), [&](const ContractionProfile::Common& neighbour) {
    return is_live_line(neighbour.edges[0]) && is_live_line(neighbour.edges[1]);
  });
  if (closes_loop || takes_a_line_away(complex, profile)) return true;
  if (!is_feature_[pair.id] || is_seam(pair.id)) return false;
  // The vertex that moves takes its line's next edge along.
  const Index moved = moved_end(pair, complex.position(pair.a), position) == 0 ? pair.a : pair.b;
  const std::optional<Index> next = other_feature_edge(complex, moved, pair.id);
  if (!next) return false;
  const auto [p, q] = complex.ends(*next);
  const Vec3& end = complex.position(p == moved ? q : p);
  const auto is_far = [&](const Vec3& point) { return distance_sq_to_segment(point, position, end) > tolerance_sq_; };
  if (is_far(complex.position(moved))) return true;
  for (const Index edge : {pair.id, *next}) {
    const auto course = courses_.find(edge);
    if (course != courses_.end() && std::any_of(course->second.begin(), course->second.end(), is_far)) return true;
  }
  return false;
}

FeatureLines Constraints::lines(TriangleComplex& complex, const std::vector<Index>& numbers) const {
  std::vector<std::pair<VertexPair, Index>> edges;
  for (Index e = 0; e < is_feature_.size(); ++e) {
    if (!is_feature_[e] || !complex.is_pair_alive(e)) continue;
    const auto [a, b] = complex.ends(e);
    const auto [low, high] = std::minmax(numbers[a], numbers[b]);
    edges.push_back({{low, high}, e});
  }
  std::sort(edges.begin(), edges.end());
  FeatureLines lines;
  for (const auto& [ends, e] : edges) {
    const auto course = courses_.find(e);
    lines.edges.push_back(ends);
    lines.courses.push_back(course == courses_.end() ? Course{} : course->second);
    if (has_seams()) lines.is_seam.push_back(static_cast<std::uint8_t>(is_seam(e)));
  }
  lines.corners.emplace();
  for (Index v = 0; v < constraints_.size(); ++v) {
    if (constraints_[v] == Constraint::at_corner && numbers[v] != invalid_index) lines.corners->push_back(numbers[v]);
  }
  return lines;
}

/// The other feature edge of an end on a line, as it was before the contraction.
std::optional<Index> Constraints::other_feature_edge_before(const TriangleComplex& complex,
                                                            const ContractionProfile& profile, const Change& change,
                                                            std::size_t end) const {
  const auto& [id, a, b] = change.pair;
  if (constraints_[end == 0 ? a : b] != Constraint::on_line) return std::nullopt;
  for (const Change::MergedEdges& merged : change.edges) {
    if (is_feature_[merged.edges[end]]) return merged.edges[end];
  }
  const auto is_merged = [&change](Index v) {
    return std::any_of(change.edges.begin(), change.edges.end(),
                       [v](const auto& merged) { return merged.vertex == v; });
  };
  for (const Neighbour& neighbour : (end == 0 ? profile.first : profile.second).neighbours()) {
    if (is_merged(neighbour.vertex)) continue;
    const Index e = complex.live_edge(neighbour.edge);
    if (is_feature_[e]) return e;
  }
  return std::nullopt;
}

/// The course of a contracted feature edge goes to the next edge of its line.
void Constraints::merge_courses(const TriangleComplex& complex, const ContractionProfile& profile,
                                const Change& change) {
  const std::size_t moved = moved_end(change.pair, change.before[0], change.position);
  const Course course = std::move(courses_[change.pair.id]);
  courses_.erase(change.pair.id);
  const std::optional<Index> next = other_feature_edge_before(complex, profile, change, moved);
  if (!next) return;
  Course& whole = courses_[*next];
  whole.push_back(change.before[moved]);
  whole.insert(whole.end(), course.begin(), course.end());
}

void Constraints::note(const TriangleComplex& complex, const ContractionProfile& profile, const Change& change) {
  if (!any()) return;
  if (is_feature(change.pair.id) && !is_seam(change.pair.id)) merge_courses(complex, profile, change);
  constraints_[change.survivor] = std::max(constraints_[change.pair.a], constraints_[change.pair.b]);
  if (!has_features()) return;
  for (const Change::MergedEdges& merged : change.edges) {
    const auto& [first, second] = merged.edges;
    const bool either = is_feature_[first] || is_feature_[second];
    for (const auto& [from, to] : {std::pair(first, second), std::pair(second, first)}) {
      if (is_feature_[from] && !is_feature_[to] && courses_.contains(from)) courses_[to] = courses_[from];
    }
    if (has_seams()) {
      const auto is_hard = [this](Index edge) { return is_feature_[edge] && !is_seam_[edge]; };
      is_seam_[first] = is_seam_[second] = either && !is_hard(first) && !is_hard(second);
    }
    is_feature_[first] = is_feature_[second] = either;
  }
}

}  // namespace whittle
