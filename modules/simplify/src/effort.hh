#pragma once

#include "whittle/simplify/simplify.hh"

namespace whittle {

/// `with_effort` for a mesh of which it is known that it has no two-sided sheets.
SimplifyOptions with_effort_on_one_side(Effort effort, SimplifyOptions options, const IndexedMesh& mesh,
                                        const DecimateTarget& target);

}  // namespace whittle
