#pragma once

#include <cstddef>
#include <span>

#include "complex/triangle_complex.hh"
#include "cost/memory.hh"
#include "whittle/core/detail/compiler.hh"
#include "whittle/engine/formula/pair_evaluation.hh"
#include "whittle/engine/host.hh"

namespace whittle {

/// What a cost keeps about a vertex, as memory to be fetched before it is asked for.
struct VertexState {
  const std::byte* begin = nullptr;
  std::size_t stride = 0;  ///< bytes a vertex; 0 = nothing is kept

  void prefetch(Index v) const { prefetch_line(begin + stride * v); }
};

/// What a cost knows of a surface, from pass to pass. No function has a default: a cost that forgets one does not
/// compile. Costs that keep nothing derive from `StatelessCost`.
class CostState {
 public:
  virtual ~CostState() = default;

  virtual void see_faces(unsigned threads) = 0;
  /// \param planes of seams and rims (`seam_planes`), by number in the input
  virtual void see_seams(std::span<const Memory::Remembered> planes) = 0;
  virtual void see_attributes(SurfaceAttributes&& attributes) = 0;
  virtual void start(unsigned threads) = 0;
  /// Takes what was kept about vertices from an earlier run. Called after `start`. \param state by number in the input
  virtual void resume(const DecimationState& state) = 0;
  /// Takes what is known from passes over the same surface before. Called after `start`.
  virtual void recall(const Memory& memory) = 0;
  /// Updates what is kept about vertices. \param profile as it was before the contraction
  virtual void merge(ContractionProfile& profile, const PairEvaluation& ranked, const Change& change) = 0;

  /// What is kept about v as a quadric: nothing, unless the cost has quadrics.
  virtual PlacedQuadric quadric(Index v) const = 0;
  /// Whether what is kept about v can't be told from its faces.
  virtual bool remembers(Index v) const = 0;
  /// The planes of seams that v remembers, if these are all that it remembers; or null.
  virtual const Quadric* remembered_seams(Index v) const = 0;
  /// What is kept about the attributes of some vertices, which get their places as numbers.
  virtual SurfaceAttributes attributes_at(std::span<const Index> vertices) const = 0;
  /// What is remembered about the faces as they were at the start.
  virtual MeanFaceArea face_area() const = 0;

  /// What ranking looks at.
  virtual VertexState vertex_state() const = 0;
  /// Whether `merge` changes what is kept about the merged vertex' neighbours.
  virtual bool changes_neighbours() const = 0;
};

}  // namespace whittle
