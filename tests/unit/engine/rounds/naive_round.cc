#include "unit/engine/rounds/naive_round.hh"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>

#include "oracle/point_distance.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/cost_traits.hh"
#include "whittle/engine/formula/flip_limit.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/formula/valence_term.hh"

namespace whittle::test {
namespace {

double distance_sq_to(const Corners& c, const Vec3& p) {
  const auto wide = [](const Vec3& v) -> LongVec3 { return v.cast<long double>(); };
  const long double distance = distance_by_features(wide(p), wide(c[0]), wide(c[1]), wide(c[2]));
  return static_cast<double>(distance * distance);
}

class NaiveRound {
 public:
  NaiveRound(const IndexedMesh& mesh, const DecimateOptions& options, const MeanFaceArea& area, const RoundLimit& limit,
             BruteForceAttributes& attributes)
      : positions_(mesh.positions),
        faces_(mesh.faces),
        placement_(options.quadric.placement),
        valence_weight_(options.valence_weight),
        area_(area),
        limit_(limit),
        attributes_(attributes),
        is_merged_(positions_.size()) {}

  std::vector<NaiveContraction> run() {
    struct Candidate {
      std::uint32_t cost_class;
      VertexPair pair;
    };
    std::vector<Candidate> candidates;
    for (Index v = 0; v < positions_.size(); ++v) {
      for (const Triangle& face : star(v)) {
        const Index w = face[1];
        if (v > w) continue;
        const float cost = CostCounts::in_range(evaluate({v, w}).cost);
        if (cost <= limit_.cost) candidates.push_back({CostCounts::class_of(cost), {v, w}});
      }
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost_class < b.cost_class; });
    for (const Candidate& candidate : candidates) {
      if (made_.size() == limit_.n_pairs) break;
      if (!is_merged_[candidate.pair.a] && !is_merged_[candidate.pair.b]) take(candidate.pair);
    }
    return made_;
  }

 private:
  /// The faces at v, each from v on.
  std::vector<Triangle> star(Index v) const {
    std::vector<Triangle> star;
    for (Triangle face : faces_) {
      if (!has_three_corners(face)) continue;
      const auto at = std::find(face.begin(), face.end(), v);
      if (at == face.end()) continue;
      std::rotate(face.begin(), at, face.end());
      star.push_back(face);
    }
    return star;
  }
  std::set<Index> neighbours(Index v) const {
    std::set<Index> all;
    for (const Triangle& face : star(v)) all.insert({face[1], face[2]});
    return all;
  }
  PlacedQuadric placed(Index v) const {
    PlacedQuadric placed{positions_[v], {}};
    for (const auto& [a, b, c] : star(v)) {
      placed.quadric.a += corner_quadric(positions_[a], positions_[b], positions_[c], {});
    }
    return placed;
  }
  PairEvaluation evaluate(const VertexPair& pair) const {
    const PlacedQuadric a = placed(pair.a);
    const PlacedQuadric b = placed(pair.b);
    PairEvaluation result = evaluate_pair(a, b, placement_);
    if (attributes_.any()) {
      const auto [quadric, most] = attributes_.of(pair.a, pair.b, true, b.position - a.position);
      PlacedQuadric all = a;
      all.quadric += quadric;
      const PairEvaluation with_attributes = evaluate_pair(all, b, placement_);
      if (quadric(with_attributes.position - a.position) <= most) {
        result = with_attributes;
      } else {
        result.cost += most;
      }
    }
    result.cost *= memoryless_factor(a.quadric.a.trace() + b.quadric.a.trace(), area_.first());
    if (valence_weight_ > 0) result.cost = with_penalty(pair, CostCounts::in_range(result.cost));
    return result;
  }
  /// \pre the surface is closed
  double with_penalty(const VertexPair& pair, double cost) const {
    const std::set<Index> of_a = neighbours(pair.a);
    const std::set<Index> of_b = neighbours(pair.b);
    std::set<Index> opposites;
    for (const Triangle& face : pair_star(pair).both) opposites.insert(face[0] + face[1] + face[2] - pair.a - pair.b);
    ValenceChange change;
    change.add_before(static_cast<int>(of_a.size()), false);
    change.add_before(static_cast<int>(of_b.size()), false);
    change.add_after(static_cast<int>(of_a.size() + of_b.size() - 2 - opposites.size()), false);
    for (const Index v : opposites) {
      const auto valence = static_cast<int>(neighbours(v).size());
      change.add_before(valence, false);
      change.add_after(valence - 1, false);
    }
    return change.penalize(cost, valence_weight_);
  }
  static bool has(const Triangle& face, Index v) { return std::find(face.begin(), face.end(), v) != face.end(); }

  /// The faces at either vertex of a pair.
  struct PairStar {
    std::vector<Triangle> only_a, only_b, both;
  };
  PairStar pair_star(const VertexPair& pair) const {
    PairStar all;
    for (const Triangle& face : star(pair.a)) (has(face, pair.b) ? all.both : all.only_a).push_back(face);
    for (const Triangle& face : star(pair.b)) {
      if (!has(face, pair.a)) all.only_b.push_back(face);
    }
    return all;
  }

  bool keeps_topology(const VertexPair& pair, const PairStar& all) const {
    const std::set<Index> of_a = neighbours(pair.a);
    const std::set<Index> of_b = neighbours(pair.b);
    std::vector<Index> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
    if (all.both.size() != 2 || common.size() != 2) return false;
    return all.only_a.size() > 1 || all.only_b.size() > 1;
  }

  StarVolume volume(const PairStar& all, const Vec3& origin) const {
    StarVolume sums;
    for (const auto* part : {&all.only_a, &all.only_b, &all.both}) {
      for (const auto& [a, b, c] : *part) {
        const Vec3 normal = (positions_[b] - positions_[a]).cross(positions_[c] - positions_[a]);
        sums.normal += normal;
        sums.offset += normal.dot(positions_[a] - origin);
        sums.length += normal.norm();
        if (part == &all.both) continue;
        for (const Index v : {b, c}) {
          sums.farthest_sq = std::max(sums.farthest_sq, (positions_[v] - origin).squaredNorm());
        }
      }
    }
    return sums;
  }

  bool turns(const PairStar& all, const Vec3& to) const {
    const FlipLimit limit(cost_traits(Cost::memoryless).default_max_normal_flip_deg);
    const auto turns_one = [&](const Triangle& face) {
      return limit.is_exceeded(positions_[face[0]], to, positions_[face[1]], positions_[face[2]]);
    };
    return std::any_of(all.only_a.begin(), all.only_a.end(), turns_one) ||
           std::any_of(all.only_b.begin(), all.only_b.end(), turns_one);
  }

  double displacement_sq(const VertexPair& pair, const PairStar& all, const Vec3& to) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double of_a = infinity;
    double of_b = infinity;
    double of_merged = infinity;
    for (const auto* part : {&all.only_a, &all.only_b, &all.both}) {
      for (const auto& [v, x, y] : *part) {
        of_merged = std::min(of_merged, distance_sq_to({positions_[v], positions_[x], positions_[y]}, to));
        if (part == &all.both) continue;
        const Corners after{to, positions_[x], positions_[y]};
        of_a = std::min(of_a, distance_sq_to(after, positions_[pair.a]));
        of_b = std::min(of_b, distance_sq_to(after, positions_[pair.b]));
      }
    }
    return std::max({of_a, of_b, of_merged});
  }

  void take(const VertexPair& pair) {
    const PairEvaluation ranked = evaluate(pair);
    const PairStar all = pair_star(pair);
    if (CostCounts::in_range(ranked.cost) > limit_.cost || !keeps_topology(pair, all)) return;
    const StarVolume sums = volume(all, ranked.position);
    Vec3 position = ranked.position;
    if (ranked.is_minimum) position += volume_step(placed(pair.a).quadric.a + placed(pair.b).quadric.a, sums);
    if (turns(all, position)) position = ranked.position;
    if (turns(all, position)) return;
    if (sums.is_thin()) {
      const auto n_faces = static_cast<std::uint64_t>(std::count_if(faces_.begin(), faces_.end(), has_three_corners));
      const double cost = thin_cost(displacement_sq(pair, all, position), area_.now(n_faces));
      if (CostCounts::in_range(cost) > limit_.cost) return;
    }
    is_merged_[pair.a] = is_merged_[pair.b] = true;
    const bool stays_at_first = placement_ == Placement::endpoint && position == positions_[pair.a];
    const Index survivor = stays_at_first ? pair.a : pair.b;
    const Index removed = stays_at_first ? pair.b : pair.a;
    if (attributes_.any()) attributes_.contract(pair.a, pair.b, survivor, true, positions_, position);
    positions_[survivor] = position;
    for (Triangle& face : faces_) std::replace(face.begin(), face.end(), removed, survivor);
    made_.push_back({survivor, removed, position});
  }

  std::vector<Vec3> positions_;
  std::vector<Triangle> faces_;
  Placement placement_;
  double valence_weight_;
  MeanFaceArea area_;
  RoundLimit limit_;
  BruteForceAttributes& attributes_;
  std::vector<bool> is_merged_;
  std::vector<NaiveContraction> made_;
};

}  // namespace

std::vector<NaiveContraction> naive_round(const IndexedMesh& mesh, const DecimateOptions& options,
                                          const MeanFaceArea& area, const RoundLimit& limit,
                                          BruteForceAttributes& attributes) {
  return NaiveRound(mesh, options, area, limit, attributes).run();
}

}  // namespace whittle::test
