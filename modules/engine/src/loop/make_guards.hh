#pragma once

#include "complex/restraints.hh"
#include "complex/triangle_complex.hh"
#include "guard/guard.hh"
#include "loop/stage_context.hh"
#include "pairs/threshold_pair_sieve.hh"

namespace whittle {

/// The guards that a stage asks for. A new guard gets a line in there.
Guards make_guards(TriangleComplex& complex, const Restraints& restraints, ThresholdPairSieve& sieve,
                   const StageContext& context);

}  // namespace whittle
