#pragma once

#include <vector>

#include "complex/contraction_profile.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/formula/quadric.hh"

namespace whittle {

/// Quadrics that a few vertices have, such as the planes of seams, each about its vertex.
class SparseQuadrics {
 public:
  bool empty() const { return slots_.empty(); }
  bool contains(Index v) const { return !empty() && slots_[v] != invalid_index; }
  const Quadric* find(Index v) const { return contains(v) ? &quadrics_[slots_[v]] : nullptr; }

  /// \param n_vertices that there are
  void set(Index v, const Quadric& quadric, std::size_t n_vertices) {
    if (empty()) slots_.assign(n_vertices, invalid_index);
    if (slots_[v] == invalid_index) {
      slots_[v] = static_cast<Index>(quadrics_.size());
      quadrics_.emplace_back();
    }
    quadrics_[slots_[v]] = quadric;
  }
  void erase(Index v) {
    if (!empty()) slots_[v] = invalid_index;
  }
  /// Leaves one vertex the sum for both, and nothing to the other. \return the sum, zero if there is none
  Quadric merge(const Change& change) {
    const Quadric* const first = find(change.pair.a);
    const Quadric* const second = find(change.pair.b);
    Quadric sum;
    if (first != nullptr) sum += first->about(change.position - change.before[0]);
    if (second != nullptr) sum += second->about(change.position - change.before[1]);
    if (first == nullptr && second == nullptr) return sum;
    const Index slot = slots_[first != nullptr ? change.pair.a : change.pair.b];
    slots_[change.removed] = invalid_index;
    slots_[change.survivor] = slot;
    quadrics_[slot] = sum;
    return sum;
  }

 private:
  std::vector<Index> slots_;  ///< a vertex, in `quadrics_`, or `invalid_index`; empty where there are none at all
  std::vector<Quadric> quadrics_;
};

}  // namespace whittle
