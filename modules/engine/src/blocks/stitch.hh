#pragma once

#include <span>

#include "blocks/block.hh"

namespace whittle {

/// Puts together what the blocks of a level have left of a surface, vertices and faces in the input's order.
WorkingSurface stitch(const WorkingSurface& surface, const Partition& partition, std::span<const Block* const> blocks,
                      const BlockResults& results, unsigned threads);

}  // namespace whittle
