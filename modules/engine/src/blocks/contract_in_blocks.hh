#pragma once

#include <array>
#include <string_view>

#include "blocks/level.hh"

namespace whittle {

/// How a mesh is cut into blocks. The defaults are for a second-level cache of half a megabyte and more.
struct BlockPlan {
  std::size_t fewest_faces = 20000;             ///< smaller meshes are not cut
  std::size_t fewest_faces_in_detail = 140000;  ///< nor are these, if contractions are told: blocks keep the order less
                                                ///< well
  std::size_t fewest_faces_again = 262144;  ///< what is left is cut once more, along other borders, if it has so many
  std::size_t faces_per_block = 16384;
  double fewest_faces_left = 256;                 ///< in a block: of fewer, too many would lie at borders
  double fewest_faces_left_before_rounds = 2048;  ///< the same, if rounds over the whole follow
  double surplus = 1.4;  ///< how many times as many vertices as the target asks for the blocks leave, borders aside
  double surplus_before_rounds = 1.2;         ///< the same, if rounds over the whole follow, to an eighth and less
  double least_surplus_before_rounds = 1.05;  ///< the same, to three tenths and more
  double highest_nonmanifold_share = 0.1;     ///< of non-manifold edges and vertices beside the vertices to be left:
                                              ///< blocks leave those as they are

  // In the exact order a block knows the less the smaller it is.
  std::size_t fewest_faces_in_exact_order = 500000;
  std::size_t fewest_faces_again_in_exact_order = 131072;
  std::array<std::size_t, 2> faces_per_block_in_exact_order{131072, 65536};  ///< by level
  double least_done_in_exact_order = 0.5;  ///< share of what the target asks for; of less, one stage over all is faster
  double surplus_in_exact_order = 1.2;     ///< with less, blocks may go beyond the target
};

/// Why a run doesn't go through blocks; empty if it does. Blocks need a cost that rises in the exact order, or another
/// order, and guards that look at the neighbours of a pair alone. Small meshes, and targets near the start, gain
/// nothing.
/// \param is_told whether contractions are
std::string_view why_not_in_blocks(const IndexedMesh& mesh, const DecimateTarget& target,
                                   const DecimateOptions& options, const DecimationHost* host, const BlockPlan& plan,
                                   bool is_told);

/// Whether blocks keep the exact order.
inline bool is_exact_in_blocks(const DecimateOptions& options) {
  return cost_traits(options.effective_cost()).goes_in_blocks_exactly;
}

/// Whether what blocks leave is contracted in rounds down to the target. Else it is left to a stage that looks at more.
bool goes_to_target(const DecimateOptions& options);

/// Whether so little of the input isn't manifold that what blocks leave may be left to rounds: they contract less of
/// that than a queue. \param before counts of the input
bool is_nearly_manifold(const SurfaceCounts& before, const DecimateTarget& target, const IndexedMesh& mesh);

/// Contracts most of what there is to contract in blocks that fit a cache, on all threads, and if `goes_to_target` the
/// rest, too. Nothing depends on the number of threads.
/// \param surface the input, or what is left of it. It stays, and `DecimateResult::why_in_one_pass` says why, if blocks
///        can't do enough
/// \param context with `StageLimits::displacement`, memoryless quadrics may cost anything
/// \return `before` has the counts of the input, unless it was cancelled, or the surface isn't the input
/// \pre why_not_in_blocks(…).empty()
StageReport contract_in_blocks(WorkingSurface& surface, const IndexedMesh& mesh, const DecimateTarget& target,
                               const BlockPlan& plan, const StageContext& context);

}  // namespace whittle
