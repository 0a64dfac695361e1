#pragma once

#include <memory>

#include "blocks/decimate_in_blocks.hh"
#include "error/error_bound.hh"

namespace whittle {

/// `decimate`, with a plan for blocks.
/// \param host null for none
/// \param error_bound gets what proofs were made with, if the error is limited; or null
Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host, const BlockPlan& plan, std::unique_ptr<ErrorBound>* error_bound = nullptr);

}  // namespace whittle
