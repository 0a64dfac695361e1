#pragma once

#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "pairs/hidden_pairs.hh"

namespace whittle {

/// Leaves out threshold pairs that need no ranking: duplicates, pairs that have become one vertex, and pairs that an
/// edge decides. On a dense mesh these are nine of ten.
class ThresholdPairFilter {
 public:
  explicit ThresholdPairFilter(TriangleComplex& complex);

  /// Sorts `pairs`, given by id: first the edges, then the threshold pairs that are to be ranked. Drops the rest.
  void apply(std::vector<Index>& pairs);

  /// If the ends of a threshold pair have a common face, hides the pair.
  bool hides(const Pair& pair);
  /// Appends the pairs hidden at v to `pairs`; they are hidden no more.
  void reveal(Index v, std::vector<Index>& pairs) { hidden_.take(v, pairs); }
  void merge(Index survivor, Index removed) { hidden_.merge(survivor, removed); }

 private:
  void look_up_alive(std::span<const Index> ids);
  bool is_duplicate(const Pair& pair);

  TriangleComplex& complex_;
  HiddenPairs hidden_;
  std::vector<Pair> known_;  ///< seen lately, by their ends
  std::vector<Pair> alive_;  ///< scratch
};

}  // namespace whittle
