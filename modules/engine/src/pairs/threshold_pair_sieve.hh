#pragma once

#include <span>
#include <vector>

#include "complex/triangle_complex.hh"
#include "pairs/hidden_pairs.hh"

namespace whittle {

/// Keeps those threshold pairs from being evaluated for which that would be in vain: duplicates, those that have become
/// one vertex, and those that an edge decides. On a dense mesh that is nine of ten.
class ThresholdPairSieve {
 public:
  explicit ThresholdPairSieve(TriangleComplex& complex);

  /// Moves the threshold pairs among `pairs`, by number, behind the edges, those of them that are to be evaluated.
  void sift(std::vector<Index>& pairs);

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
