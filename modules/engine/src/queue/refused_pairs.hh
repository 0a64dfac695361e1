#pragma once

#include <cstdint>
#include <vector>

#include "complex/triangle_complex.hh"
#include "queue/waiting_pairs.hh"

namespace whittle {

/// Pairs that were refused, each with a number for who did so. A pair waits at both its vertices, unless its refusal is
/// final.
class RefusedPairs {
 public:
  using Refuser = std::uint8_t;
  static constexpr Refuser none = 0xff;  ///< the pair is not refused

  explicit RefusedPairs(const TriangleComplex& complex)
      : waiting_(complex.n_vertex_slots()), refusers_(complex.n_pair_slots(), none) {}

  bool any_at(Index v) const { return waiting_.any_at(v); }
  Refuser refuser(Index id) const { return refusers_[id]; }

  void add(const Pair& pair, Refuser refuser) {
    const bool waits_already = refusers_[pair.id] != none;
    refusers_[pair.id] = refuser;
    if (waits_already) return;
    waiting_.add(pair.a, pair.id);
    waiting_.add(pair.b, pair.id);
  }
  void add_for_good(const Pair& pair, Refuser refuser) { refusers_[pair.id] = refuser; }

  /// Takes a pair back that was refused for good.
  void take_back(Index id) { refusers_[id] = none; }

  /// Calls `use(id)` for the pairs that wait at v.
  template <class Use>
  void for_each_at(Index v, const Use& use) const {
    waiting_.for_each_at(v, [&](Index id) {
      if (refusers_[id] != none) use(id);
    });
  }

  /// Takes out the pairs that wait at v. \param ids theirs
  void take(Index v, std::vector<Index>& ids) {
    ids.clear();
    waiting_.take(v, ids);
    std::size_t n = 0;
    for (const Index id : ids) {
      if (refusers_[id] == none) continue;  // listed twice, or already woken at its other vertex
      refusers_[id] = none;
      ids[n++] = id;
    }
    ids.resize(n);
  }

 private:
  WaitingPairs waiting_;
  std::vector<Refuser> refusers_;  ///< by id
};

}  // namespace whittle
