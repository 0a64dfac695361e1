#pragma once

#include <algorithm>
#include <cstdlib>

// A penalty for valences, the numbers of edges at vertices, times any cost:
//
//   cost · (1 + W Δ) where a contraction adds to the irregularity, cost / (1 − W Δ) where it takes away from it
//
// Δ is the change in the sum of the irregularities max(0, |n − r| − 1) of the vertices that change: the pair, which
// becomes one vertex, and the corners of the faces that vanish (the faces), which lose an edge each. r = 6, on a border
// 4; so 5 to 7 are as good as 6. A contraction that leaves a vertex inside the surface with three edges comes after all
// others: cost → (cost + 1) · 2²⁰.
//
// The usual penalty, 1 + W |n − 6|, looks at the valences afterwards alone. docs/dev/decisions.md compares both.

namespace whittle {

/// What a contraction does to the valences around it.
class ValenceChange {
 public:
  /// A vertex as it is.
  void add_before(int valence, bool on_border) { irregularity_ -= irregularity(valence, on_border); }
  /// A vertex as it would be.
  void add_after(int valence, bool on_border) {
    irregularity_ += irregularity(valence, on_border);
    leaves_three_ |= !on_border && valence <= 3;
  }

  /// \param cost of the contraction without the penalty, in the frame: of a mesh of size 1
  /// \param weight W, [0, inf)
  double penalize(double cost, double weight) const {
    if (leaves_three_) return (cost + 1) * 0x1p20;
    const double change = weight * irregularity_;
    return change >= 0 ? cost * (1 + change) : cost / (1 - change);
  }

 private:
  static int irregularity(int valence, bool on_border) {
    return std::max(0, std::abs(valence - (on_border ? 4 : 6)) - 1);
  }

  int irregularity_ = 0;
  bool leaves_three_ = false;  ///< whether a vertex inside the surface would have three edges or fewer
};

}  // namespace whittle
