#include "oracle/brute_force_attributes.hh"

#include <algorithm>
#include <utility>

namespace whittle::test {

BruteForceAttributes::BruteForceAttributes(const IndexedMesh& mesh, const Frame& frame,
                                           const DecimateOptions& options) {
  if (!looks_at_attributes(options, mesh)) return;
  ScaledAttributes attributes = scaled_attributes(mesh, frame, options.attribute_weights, 1);
  if (attributes.n_components == 0) return;
  surface_ = InputAttributes(mesh, frame, std::move(attributes)).all(1);
  wedges_of_.resize(mesh.positions.size());
  for (Index w = 0; w < surface_.vertex_of.size(); ++w) wedges_of_[surface_.vertex_of[w]].push_back(w);
}

std::vector<BruteForceAttributes::Match> BruteForceAttributes::matches(Index a, Index b, bool is_edge,
                                                                       const Vec3& a_to_b) const {
  const std::vector<Index>& at_a = wedges_of_[a];
  const std::vector<Index>& at_b = wedges_of_[b];
  const bool is_a_fewer = at_a.size() <= at_b.size();
  const auto pair = [&](Index few, Index many) { return is_a_fewer ? Match{few, many} : Match{many, few}; };
  std::vector<Index> left = is_a_fewer ? at_b : at_a;
  std::vector<Match> matches;
  for (const Index w : is_a_fewer ? at_a : at_b) {
    if (!is_edge) {
      matches.push_back(pair(w, invalid_index));
      continue;
    }
    const Vec3 to_middle = (is_a_fewer ? 0.5 : -0.5) * a_to_b;
    const auto distance = [&](Index other) { return surface_.wedges.error_between(w, other, to_middle, -to_middle); };
    const auto nearest = std::ranges::min_element(left, {}, distance);
    matches.push_back(pair(w, *nearest));
    left.erase(nearest);
  }
  for (const Index w : left) matches.push_back(pair(invalid_index, w));
  return matches;
}

BruteForceAttributes::PairCost BruteForceAttributes::of(Index a, Index b, bool is_edge, const Vec3& a_to_b) const {
  const WedgeQuadrics& wedges = surface_.wedges;
  PairCost sum;
  for (const auto& [at_a, at_b] : matches(a, b, is_edge, a_to_b)) {
    if (at_b == invalid_index) {
      sum.quadric += wedges.quadric(at_a);
    } else if (at_a == invalid_index) {
      sum.quadric += wedges.quadric(at_b).about(-a_to_b);
    } else {
      sum.quadric += wedges.quadric_of_both(at_a, at_b, a_to_b);
    }
    const auto weight = [&](Index w) { return w == invalid_index ? 0 : wedges.weight(w); };
    sum.most += surface_.farthest * surface_.farthest * (weight(at_a) + weight(at_b));
  }
  return sum;
}

void BruteForceAttributes::contract(Index a, Index b, Index survivor, bool is_edge, std::span<const Vec3> positions,
                                    const Vec3& position) {
  const std::vector<Match> all = matches(a, b, is_edge, positions[b] - positions[a]);
  for (const Index v : {a, b}) {
    for (const Index w : wedges_of_[v]) surface_.wedges.move_origin(w, position - positions[v]);
  }
  std::vector<Index> kept;
  for (const auto& [at_a, at_b] : all) {
    if (at_a != invalid_index && at_b != invalid_index) surface_.wedges.join(at_a, at_b);
    kept.push_back(at_a != invalid_index ? at_a : at_b);
  }
  std::ranges::sort(kept);
  wedges_of_[survivor == a ? b : a].clear();
  wedges_of_[survivor] = std::move(kept);
}

}  // namespace whittle::test
