#pragma once

#include <optional>
#include <vector>

#include "blocks/partition.hh"
#include "loop/contractor.hh"
#include "rounds/rounds.hh"

namespace whittle {

/// What blocks of a level leave in the level's own numbers. Each block writes to its own vertices and faces.
struct BlockResults {
  std::vector<Index> merged_into;          ///< per vertex; itself if it wasn't merged
  std::vector<std::uint8_t> is_face_left;  ///< per face
};

/// A block of a surface under contraction. Its shared vertices, and those of other blocks at its faces, are frozen.
class Block {
 public:
  /// A vertex that isn't frozen, and wasn't merged into another.
  struct Survivor {
    Index vertex;   ///< of the surface
    Vec3 position;  ///< in the frame
  };

  /// \param context of the surface, but options of the block
  Block(const WorkingSurface& surface, const Partition& partition, std::size_t number, StageContext context,
        RoundScratchPool& scratch);

  void start(const DecimateTarget& target) { rounds_ ? rounds_->start(target) : contractor_->start(target); }
  /// Contracts what costs at most so much. \param cost in the frame
  void run(double cost);
  /// If it goes in rounds: to contract blocks in step; else null.
  Rounds* rounds() { return rounds_ ? &*rounds_ : nullptr; }

  std::size_t n_inner_vertices() const { return n_inner_; }  ///< at the start: those that aren't frozen
  std::size_t n_inner_vertices_left() const { return n_inner_ - result().n_contractions; }
  std::size_t n_frozen_vertices() const { return n_frozen_; }
  DecimateResult result() const { return rounds_ ? rounds_->result() : result_; }
  NonmanifoldCounts count_nonmanifold() {
    return rounds_ ? rounds_->nonmanifold() : contractor_->complex().count_nonmanifold();
  }
  /// \return the number that a vertex of the block has in the surface
  Index number_of(Index vertex) const { return vertices_[vertex]; }

  /// Writes down what is left, and frees the rest.
  void finish(BlockResults& results);
  const std::vector<Survivor>& survivors() const { return survivors_; }
  /// Theirs, by vertex of the surface.
  const CostState& cost_state() const { return part_.cost_state; }
  /// In exact order: of pairs with an end that isn't frozen, by vertices of the surface.
  const std::vector<GuardedPair>& refusals() const { return part_.refusals; }

 private:
  void start_contractor(const StageContext& context);
  std::vector<Index> finish_rounds(BlockResults& results);
  std::vector<Index> finish_contractor(BlockResults& results);
  void gather_refusals(std::span<const GuardedPair> all);
  void gather(const WorkingSurface& surface, const Partition& partition, std::size_t number);
  std::vector<VertexQuadric> quadrics_here(std::span<const VertexQuadric> of_surface) const;
  CostState state_here(const WorkingSurface& surface) const;
  SurfaceAttributes attributes_here(const WorkingSurface& surface) const;

  std::span<const Index> own_;         ///< vertices of the surface
  std::span<const Index> own_faces_;   ///< of the surface
  std::vector<Index> vertices_;        ///< of the surface: its own and those of other blocks at its faces, ascending
  WorkingSurface part_;                ///< by vertices of the block, and by those of the surface in the end
  std::vector<std::uint8_t> frozen_;   ///< per vertex of the block, whether another block has a face there
  std::vector<std::uint8_t> locked_;   ///< per vertex of the block, or empty
  std::vector<double> displacements_;  ///< per vertex of the block, or empty
  std::size_t n_inner_ = 0;
  std::size_t n_frozen_ = 0;
  // One of the two
  std::optional<Contractor> contractor_;
  std::optional<Rounds> rounds_;
  DecimateResult result_;  ///< in the end, or that of the contractor so far
  std::vector<Survivor> survivors_;
  bool keeps_order_;          ///< exactly
  std::vector<Index> areas_;  ///< of the faces, or empty
};

}  // namespace whittle
