#pragma once

#include <span>

#include "blocks/block.hh"
#include "blocks/level.hh"

namespace whittle {

/// Puts together what the blocks of a level have left, vertices and faces in the input's order.
/// \param cost_state of the surface \param before as in `run_level`
void stitch(const Surface& surface, const Partition& partition, std::span<const Block* const> blocks,
            const BlockResults& results, const CostState& cost_state, const LevelRemainder* before, unsigned threads,
            LevelRemainder& remainder);

}  // namespace whittle
