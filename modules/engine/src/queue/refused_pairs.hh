#pragma once

#include <vector>

#include "complex/triangle_complex.hh"
#include "queue/waiting_pairs.hh"

namespace whittle {

/// Pairs that a guard refused. Each waits at both its vertices.
class RefusedPairs {
 public:
  explicit RefusedPairs(const TriangleComplex& complex)
      : waiting_(complex.n_vertex_slots()), is_refused_(complex.n_pair_slots()) {}

  bool any_at(Index v) const { return waiting_.any_at(v); }

  void add(const Pair& pair) {
    if (is_refused_[pair.id]) return;
    is_refused_[pair.id] = true;
    waiting_.add(pair.a, pair.id);
    waiting_.add(pair.b, pair.id);
  }

  /// Takes out the pairs that wait at v. \param ids theirs
  void take(Index v, std::vector<Index>& ids) {
    ids.clear();
    waiting_.take(v, ids);
    std::size_t n = 0;
    for (const Index id : ids) {
      if (!is_refused_[id]) continue;  // listed twice, or already woken at its other vertex
      is_refused_[id] = false;
      ids[n++] = id;
    }
    ids.resize(n);
  }

 private:
  WaitingPairs waiting_;
  std::vector<bool> is_refused_;  ///< by id
};

}  // namespace whittle
