#pragma once

#include "complex/constraints.hh"
#include "complex/triangle_complex.hh"
#include "guard/guard.hh"
#include "loop/stage_context.hh"
#include "pairs/threshold_pair_filter.hh"

namespace whittle {

/// The guards that a stage asks for. A new guard gets a line in there.
Guards make_guards(TriangleComplex& complex, const Constraints& constraints, ThresholdPairFilter& filter,
                   const StageContext& context);

}  // namespace whittle
