#pragma once

#include <vector>

#include "whittle/engine/two_sided_sheets.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle {

/// `simplify` for a mesh with two-sided sheets. \pre the mesh has sheets
Simplification simplify_sheets(const TwoSidedSheets& sheets, const DecimateTarget& target, Effort effort,
                               const SimplifyOptions& options);

/// `simplify_to_levels` for a mesh with two-sided sheets. \pre the mesh has sheets; the targets are possible
std::vector<Simplification> simplify_sheets_to_levels(const TwoSidedSheets& sheets,
                                                      const std::vector<DecimateTarget>& targets, Effort effort,
                                                      const SimplifyOptions& options);

}  // namespace whittle
