#include "memoryless_cost.hh"

namespace whittle {

/// Whether the merged vertex, and its neighbours, get the planes of its faces alone.
bool MemorylessCost::forgets(const Pair& pair, const PairStar& star) const {
  return !star.is_joint && complex_.is_ring(pair.a) && complex_.is_ring(pair.b);
}

Vec3 MemorylessCost::place(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) {
  if (!forgets(pair, star)) return evaluation.position;
  ring_origin_ = evaluation.position;
  ring_.assign(complex_, pair, star, ring_origin_);
  if (!evaluation.is_minimum) return evaluation.position;
  const SymmetricMatrix sum = complex_.placed(pair.a).quadric.a + complex_.placed(pair.b).quadric.a;
  return evaluation.position + volume_step(sum, ring_.volume());
}

PlacedQuadric MemorylessCost::merge(const Pair& pair, const PairEvaluation& evaluation, const PairStar& star) {
  const bool forgotten = forgets(pair, star);
  remembers_[pair.a] = remembers_[pair.b] = !forgotten;
  if (!forgotten) return quadric_cost_.merge(pair, evaluation, star);
  Quadric quadric;
  quadric.a = ring_.move_to(evaluation.position - ring_origin_, options_);
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Index neighbour = ring_.vertex(i);
    if (complex_.is_ring(neighbour) && !remembers_[neighbour]) complex_.change_planes(neighbour, ring_.change(i));
  }
  return {evaluation.position, quadric};
}

}  // namespace whittle
