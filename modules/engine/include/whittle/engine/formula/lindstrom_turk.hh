#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/formula/quadric.hh"
#include "whittle/engine/formula/volume_placement.hh"

// Lindstrom–Turk cost and placement of contracting an edge (v0, v1) to v̄, from the faces and border edges at the two
// vertices as they are now: nothing is remembered. Up to three linear constraints on v̄ are found, in this order, each
// taken only if it is independent of those before:
//
//   volume preservation     Σ n_t · v̄ = Σ n_t · p_t: the volume under the surface stays what it is
//   boundary preservation   |Σ A_e(v̄)|² least: so does, as far as can be, the area that the border sweeps, as a vector
//   volume and boundary     f = λ f_V + (1 − λ) L² f_B least, f_V = Σ V_t(v̄)², f_B = Σ |A_e(v̄)|²
//   optimisation
//   triangle shape          Σ |v̄ − p_i|² least, over the neighbours p_i of v0 and of v1, once each where both have a
//                           face with them
//
//   cost = f(v̄) and a trace of spread (`lindstrom_turk_regularization`), unit: length⁶
//
// t runs over the faces at v0 or v1, e over the border edges there, n_t is the normal of a face, as long as twice its
// area, p_t one of its corners, V_t(x) = n_t · (x − p_t) / 6 the volume of the tetrahedron it makes with x,
// A_e(x) = (p × q − x × (q − p)) / 2 the area vector of the triangle that a border edge from p to q makes with it, L
// the length of the edge, λ = 1/2.
//
// Sums are about some local origin o: x, p and q stand for what they are as seen from there.
// \cite lindstrom_1998_fast (sections 4 and 5), \cite lindstrom_1999_evaluation

namespace whittle {

/// Sums over border edges, each from p to q in the order of its face.
struct BorderSums {
  Vec3 edge = Vec3::Zero();  ///< Σ (q − p)
  Vec3 area = Vec3::Zero();  ///< Σ p × q
  Quadric squares;           ///< x ↦ Σ |p × q − x × (q − p)|²
  int n_edges = 0;

  void add(const Vec3& p, const Vec3& q);
};

/// Linear constraints on a point, at most three: rows a · x = b of unit length, independent of one another.
class PointConstraints {
 public:
  std::size_t size() const { return n_; }

  /// Takes a · x = b if a is longer than `noise`, and at least 1° off what the constraints taken before fix.
  void add(const Vec3& a, double b, double noise);
  /// Takes those that make xᵀ A x + 2 bᵀ x + c least, subject to the constraints taken before.
  void add_least(const Quadric& quadric);
  /// The point that fulfils all three. \pre size() == 3
  Vec3 solve() const;

 private:
  std::array<Vec3, 3> rows_;
  std::array<double, 3> values_{};
  std::size_t n_ = 0;
};

/// What contracting one edge would cost, and where v̄ would go.
class LindstromTurk {
 public:
  /// \param first, second v0 and v1 as seen from the sums' origin
  LindstromTurk(const VolumeLanes<double>& volume, const BorderSums& border, const Vec3& first, const Vec3& second);

  /// Whether v̄ is fixed already, so that `add_neighbours` would change nothing.
  bool is_determined() const { return by_volume_ ? by_volume_->has_third : constraints_.size() == 3; }
  /// Lets triangle shape decide what is not fixed.
  void add_neighbours(const NeighbourLanes<double>& neighbours);

  /// There is no lower bound, as a contraction nearby may lower the cost: `bound` is the cost. The position is seen
  /// from the sums' origin. Without three constraints, or where they place v̄ farther off than `max_placement_reach`, v̄
  /// is the best of both ends and the midpoint.
  PairEvaluation evaluate(PairConstraint constraint) const;

 private:
  std::optional<PairEvaluation> at_constraints() const;
  PairEvaluation at(const Vec3& position) const;
  PairEvaluation at_better_end() const;
  PairEvaluation at_best_candidate() const;

  VolumeLanes<double> volume_;
  Quadric objective_;  ///< f
  Vec3 first_, second_;
  std::optional<VolumeConstraints<double>> by_volume_;  ///< inside a surface that is one; else there are `constraints_`
  PointConstraints constraints_;
};

/// An evaluation about the first vertex, with its position in the frame. If v̄ is at the second vertex, it has that
/// one's position to the bit.
inline PairEvaluation in_frame(PairEvaluation evaluation, const Vec3& first, const Vec3& second) {
  const bool is_second = evaluation.position == second - first;
  evaluation.position = is_second ? second : Vec3(first + evaluation.position);
  return evaluation;
}

}  // namespace whittle
