#include "oracle/brute_force_constraints.hh"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "support/face_list.hh"

namespace whittle::test {
namespace {

double cosine_of(double angle_deg) { return std::cos(angle_deg * std::numbers::pi / 180); }

double distance_to_segment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const Vec3 offset = point - from;
  const double share = way.squaredNorm() > 0 ? std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
  return (offset - share * way).norm();
}

/// The normal of a face; reversed if the face has the edge (x, y) in the other direction.
Vec3 normal_along(std::span<const Vec3> positions, const Triangle& face, Index x, Index y) {
  const std::size_t corner = corner_of(face, x);
  const Vec3& p = positions[x];
  const Vec3 normal = (positions[face[(corner + 1) % 3]] - p).cross(positions[face[(corner + 2) % 3]] - p);
  return face[(corner + 1) % 3] == y ? normal : Vec3(-normal);
}

std::vector<Triangle> faces_at(std::span<const Triangle> faces, Index x, Index y) {
  std::vector<Triangle> found;
  for (const Triangle& f : faces) {
    if (has(f, x) && has(f, y)) found.push_back(f);
  }
  return found;
}

std::set<Index> neighbours_of(std::span<const Triangle> faces, Index v) {
  std::set<Index> neighbours;
  for (const Triangle& f : faces) {
    if (has(f, v)) neighbours.insert(f.begin(), f.end());
  }
  neighbours.erase(v);
  return neighbours;
}

}  // namespace

BruteForceConstraints::BruteForceConstraints(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                             const std::vector<bool>& locked, const DecimateOptions& options,
                                             double tolerance, std::span<const VertexPair> seams)
    : sharp_angle_deg_(options.feature_angle_deg.value_or(180)),
      seams_have_planes_(options.cost == Cost::quadric || options.cost == Cost::memoryless),
      seams_give_way_(seams_have_planes_ && options.seams == Seams::weighted && options.isotropy == 0),
      tolerance_(tolerance),
      constraints_(positions.size(), Constraint::free) {
  std::set<Edge> asked_for;
  for (const auto& [a, b] : options.feature_edges) asked_for.insert(edge(a, b));
  for (const auto& [ends, n_faces] : count_edge_faces(faces)) {
    const bool is_on = sharp_angle_deg_ < 180;
    const bool is_one = asked_for.contains(ends) || (is_on && is_sharp(positions, faces, ends.first, ends.second));
    if (is_one) features_[ends];
  }
  for (const auto& [a, b] : seams) {
    if (!features_.contains({a, b})) seams_.insert({a, b});
    if (!seams_give_way_) features_[{a, b}];
  }
  mark_constraints(positions, sharp_angle_deg_);
  for (Index v = 0; v < positions.size(); ++v) {
    if (locked[v]) constraints_[v] = Constraint::locked;
  }
}

void BruteForceConstraints::mark_constraints(std::span<const Vec3> positions, double corner_angle_deg) {
  std::map<Index, std::vector<Index>> others;
  for (const auto& [ends, course] : features_) {
    others[ends.first].push_back(ends.second);
    others[ends.second].push_back(ends.first);
  }
  for (const auto& [v, ends] : others) {
    constraints_[v] = Constraint::at_corner;
    if (ends.size() != 2) continue;
    const bool is_first_soft = is_seam(v, ends[0]);
    if (is_first_soft != is_seam(v, ends[1])) continue;
    if (is_first_soft) {
      constraints_[v] = Constraint::on_line;
      continue;
    }
    const Vec3 in = positions[v] - positions[ends[0]];
    const Vec3 out = positions[ends[1]] - positions[v];
    const bool turns = in.dot(out) < cosine_of(corner_angle_deg) * in.norm() * out.norm();
    if (!turns) constraints_[v] = Constraint::on_line;
  }
}

bool BruteForceConstraints::is_feature(Index a, Index b) const { return features_.contains(edge(a, b)); }

bool BruteForceConstraints::may_move(Index v, bool along_feature) const {
  return constraints_[v] == Constraint::free || (constraints_[v] == Constraint::on_line && along_feature);
}

std::optional<PairConstraint> BruteForceConstraints::of(Index a, Index b) const {
  const bool along_feature = is_feature(a, b);
  const bool a_may_move = may_move(a, along_feature);
  const bool b_may_move = may_move(b, along_feature);
  const bool is_free = !along_feature || (is_seam(a, b) && seams_have_planes_);
  if (a_may_move && b_may_move) return is_free ? PairConstraint::none : PairConstraint::either;
  if (a_may_move) return PairConstraint::second;
  if (b_may_move) return PairConstraint::first;
  return std::nullopt;
}

BruteForceConstraints::Move BruteForceConstraints::move_along(Index a, Index b, const Vec3& from_a,
                                                              const Vec3& to) const {
  const PairConstraint where = of(a, b).value();
  const bool goes_to_a = where == PairConstraint::first || (where == PairConstraint::either && to == from_a);
  Move move{goes_to_a ? b : a, {}};
  for (const auto& [ends, course] : features_) {
    const bool is_at_moved = ends.first == move.moved || ends.second == move.moved;
    if (is_at_moved && ends != edge(a, b)) move.next = ends;
  }
  return move;
}

bool BruteForceConstraints::keeps_lines(std::span<const Vec3> positions, std::span<const Triangle> faces, Index a,
                                        Index b, const Vec3& position) const {
  if (features_.empty()) return true;
  for (const Index v : neighbours_of(faces, a)) {
    if (v != b && is_feature(a, v) && is_feature(b, v)) return false;
  }
  if (!is_feature(a, b) || is_seam(a, b)) return true;
  const auto [moved, next] = move_along(a, b, positions[a], position);
  if (!next) return true;
  std::vector<Vec3> passed{positions[moved]};
  for (const Edge& part : {edge(a, b), *next}) {
    const Course& course = features_.at(part);
    passed.insert(passed.end(), course.begin(), course.end());
  }
  const Vec3& end = positions[next->first == moved ? next->second : next->first];
  return std::ranges::none_of(
      passed, [&](const Vec3& point) { return distance_to_segment(point, position, end) > tolerance_; });
}

bool BruteForceConstraints::keeps_edges(std::span<const Triangle> after, Index survivor, Index removed) const {
  return std::ranges::all_of(features_, [&](const auto& feature) {
    const auto [x, y] = feature.first;
    const auto now = [&](Index v) { return v == removed ? survivor : v; };
    return now(x) == now(y) || !faces_at(after, now(x), now(y)).empty();
  });
}

bool BruteForceConstraints::is_sharp(std::span<const Vec3> positions, std::span<const Triangle> faces, Index x,
                                     Index y) const {
  const std::vector<Triangle> at = faces_at(faces, x, y);
  if (at.size() != 2) return false;
  const Vec3 n = normal_along(positions, at[0], x, y);
  const Vec3 m = -normal_along(positions, at[1], x, y);
  return n.dot(m) < cosine_of(sharp_angle_deg_) * n.norm() * m.norm();
}

/// Checks the edges of the merged vertex and its link edges. A link edge that does not have two faces before the
/// contraction can't become sharp. An edge of one face is not sharp; what edges of more are is left open.
bool BruteForceConstraints::keeps_sharpness(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                            std::span<const Triangle> after, Index a, Index b,
                                            const Vec3& position) const {
  if (sharp_angle_deg_ == 180) return true;
  std::vector<Vec3> moved(positions.begin(), positions.end());
  moved[a] = position;
  const auto is_kept = [&](bool was_sharp, bool is_feature_after, Index x, Index y) {
    if (faces_at(after, x, y).size() > 2) return true;
    const bool is_sharp_after = is_sharp(moved, after, x, y);
    return is_sharp_after == was_sharp || is_sharp_after == is_feature_after;
  };
  for (const Triangle& f : after) {
    if (!has(f, a)) continue;
    const std::size_t corner = corner_of(f, a);
    const Index x = f[(corner + 1) % 3];
    const Index y = f[(corner + 2) % 3];
    const bool has_two_faces = faces_at(faces, x, y).size() == 2 && faces_at(after, x, y).size() == 2;
    if (has_two_faces && !is_kept(is_sharp(positions, faces, x, y), is_feature(x, y), x, y)) return false;
  }
  for (const Index x : neighbours_of(after, a)) {
    const bool was_sharp = is_sharp(positions, faces, a, x) || is_sharp(positions, faces, b, x);
    if (!is_kept(was_sharp, is_feature(a, x) || is_feature(b, x), a, x)) return false;
  }
  return true;
}

void BruteForceConstraints::contract(std::span<const Vec3> positions, std::span<const Triangle> after, Index survivor,
                                     Index removed, const Vec3& position) {
  if (seams_give_way_) seams_.clear();  // their planes are summed already
  const auto [a, b] = edge(survivor, removed);
  if (is_seam(a, b)) {
    features_.erase({a, b});
  } else if (is_feature(a, b)) {
    const auto [moved, next] = move_along(a, b, positions[a], position);
    const Course course = features_.at({a, b});
    features_.erase({a, b});
    if (next) {
      Course& whole = features_.at(*next);
      whole.push_back(positions[moved]);
      whole.insert(whole.end(), course.begin(), course.end());
    }
  }
  constraints_[survivor] = std::max(constraints_[a], constraints_[b]);
  std::map<Edge, Course> features;
  const auto now = [&](Index v) { return v == removed ? survivor : v; };
  for (const auto& [ends, course] : features_) {
    const Edge merged = edge(now(ends.first), now(ends.second));
    if (!faces_at(after, merged.first, merged.second).empty()) features[merged] = course;
    const bool is_soft = seams_.contains(ends) && !seams_.contains(merged) && !features_.contains(merged);
    if (is_soft) seams_.insert(merged);
  }
  features_ = std::move(features);
}

std::vector<BruteForceConstraints::Edge> BruteForceConstraints::feature_edges() const {
  std::vector<Edge> edges;
  for (const auto& [ends, course] : features_) edges.push_back(ends);
  return edges;
}

}  // namespace whittle::test
