#pragma once

#include "blocks/decimate_in_blocks.hh"

namespace whittle {

/// `decimate`, with a plan for blocks. \param host null for none
Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host, const BlockPlan& plan);

}  // namespace whittle
