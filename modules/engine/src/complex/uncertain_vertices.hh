#pragma once

#include <vector>

#include "complex/triangle_complex.hh"

namespace whittle {

/// The vertices of a block that contractions elsewhere may have changed, or will: at first the frozen ones. In the
/// exact order a pair is contracted in the block only if all vertices around it are certain (docs/dev/blocks.md).
class UncertainVertices {
 public:
  explicit UncertainVertices(const TriangleComplex& complex) : flags_(complex.n_vertex_slots()) {
    for (Index v = 0; v < flags_.size(); ++v) flags_[v] = complex.is_frozen(v);
  }

  bool contains(Index v) const { return flags_[v] != 0; }
  bool contains_any(const Pair& pair) const { return (flags_[pair.a] | flags_[pair.b]) != 0; }
  /// Whether it has an end of the pair, or a neighbour of one.
  bool contains_any_around(const ContractionProfile& profile) const {
    unsigned any = flags_[profile.pair.a] | flags_[profile.pair.b];
    profile.for_each_neighbour([&](Index v) { any |= flags_[v]; });
    return any != 0;
  }
  void add(Index v) { flags_[v] = 1; }

 private:
  std::vector<std::uint8_t> flags_;
};

}  // namespace whittle
