#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "rounds/cost_counts.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {

/// Pairs that were refused, or cost more than their rank, and wait until the faces at one of their vertices change.
class HeldPairs {
 public:
  explicit HeldPairs(std::size_t n_vertices) : last_change_(n_vertices), has_pairs_(n_vertices) {}

  // \param now the number of contractions so far

  void add_refused(const VertexPair& pair, Index now) { held_.push_back({pair, CostCounts::never, now}); }
  void add_dear(const VertexPair& pair, float cost, Index now) { held_.push_back({pair, cost, now}); }
  /// The faces at v change.
  void note_change(Index v, Index now) { last_change_[v] = now; }

  /// Lets pairs go whose faces have changed, and holds the others from now on.
  void begin_round() {
    std::erase_if(held_, [this](const Held& held) {
      return std::max(last_change_[held.pair.a], last_change_[held.pair.b]) > held.since;
    });
    std::sort(held_.begin(), held_.end(), [](const Held& a, const Held& b) { return a.pair < b.pair; });
    std::fill(has_pairs_.begin(), has_pairs_.end(), 0);
    for (const Held& held : held_) has_pairs_[held.pair.a] = has_pairs_[held.pair.b] = 1;
  }

  /// What a pair costs. \param cost its rank
  float cost(const VertexPair& pair, float cost) const {
    if ((has_pairs_[pair.a] & has_pairs_[pair.b]) == 0) return cost;
    const auto at = std::lower_bound(held_.begin(), held_.end(), pair,
                                     [](const Held& held, const VertexPair& sought) { return held.pair < sought; });
    return at != held_.end() && at->pair == pair ? std::max(cost, at->cost) : cost;
  }
  /// Raises the costs of pairs to what they cost. \param pairs ascending by their first vertices
  void raise(std::span<const VertexPair> pairs, std::span<float> costs) const {
    if (pairs.empty()) return;
    auto held = std::lower_bound(held_.begin(), held_.end(), pairs.front().a,
                                 [](const Held& h, Index a) { return h.pair.a < a; });
    for (; held != held_.end() && held->pair.a <= pairs.back().a; ++held) {
      auto at = std::lower_bound(pairs.begin(), pairs.end(), held->pair.a,
                                 [](const VertexPair& pair, Index a) { return pair.a < a; });
      while (at != pairs.end() && at->a == held->pair.a && at->b != held->pair.b) ++at;
      if (at == pairs.end() || *at != held->pair) continue;
      float& cost = costs[static_cast<std::size_t>(at - pairs.begin())];
      cost = std::max(cost, held->cost);
    }
  }

 private:
  struct Held {
    VertexPair pair;
    float cost;
    Index since;  ///< number of contractions
  };
  std::vector<Held> held_;               ///< ascending, but for those of this round
  std::vector<Index> last_change_;       ///< per vertex, number of contractions
  std::vector<std::uint8_t> has_pairs_;  ///< per vertex
};

}  // namespace whittle
