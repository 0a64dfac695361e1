#pragma once

#include <memory>

#include "blocks/contract_in_blocks.hh"
#include "error/error_bounds.hh"

namespace whittle {

/// `decimate`, with a plan for blocks.
/// \param host null for none
/// \param error_bounds gets what proofs were made with, if the error is limited; or null
/// \param keeps_in_charts as that of `carry_attributes`
Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host, const BlockPlan& plan, std::unique_ptr<ErrorBounds>* error_bounds = nullptr,
               bool keeps_in_charts = true);

}  // namespace whittle
