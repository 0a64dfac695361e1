#pragma once

#include <span>

#include "cost/attributes/attribute_quadrics.hh"
#include "rounds/star_planes.hh"
#include "whittle/core/vertex_pair.hh"
#include "whittle/engine/formula/pair_evaluation.hh"

namespace whittle {

/// What pairs cost whose vertices have the planes of their faces alone (memoryless_term.hh). Each costs the same among
/// others as alone.
class PairCosts {
 public:
  /// \param first_area a₀ \param placement of merged vertices
  PairCosts(std::span<const LanePoint> points, std::span<const StarPlanes> stars, double first_area,
            Placement placement = Placement::optimal)
      : points_(points), stars_(stars), first_area_(first_area), placement_(placement) {}

  /// \param costs per pair, rounded to single precision
  void rank(std::span<const VertexPair> pairs, std::span<float> costs) const;
  /// The same with attributes.
  void rank(std::span<const VertexPair> pairs, const AttributeQuadrics& attributes, std::span<float> costs) const;
  PairEvaluation of(const VertexPair& pair) const;
  /// Of vertices that know other planes besides.
  PairEvaluation of(const PlacedQuadric& first, const PlacedQuadric& second,
                    PairConstraint constraint = PairConstraint::none) const;
  // With attributes.
  PairEvaluation of(const VertexPair& pair, const AttributeQuadrics& attributes) const;
  PairEvaluation of(const VertexPair& pair, const PlacedQuadric& first, const PlacedQuadric& second,
                    const AttributeQuadrics& attributes, PairConstraint constraint = PairConstraint::none) const;

 private:
  struct Kernels;
  PairEvaluation in_unit(PairEvaluation evaluation, const PlacedQuadric& first, const PlacedQuadric& second) const;
  PlacedQuadric placed(Index v) const { return {points_[v], {stars_[v].matrix(), Vec3::Zero(), 0}}; }

  std::span<const LanePoint> points_;
  std::span<const StarPlanes> stars_;
  double first_area_;
  Placement placement_;
};

}  // namespace whittle
