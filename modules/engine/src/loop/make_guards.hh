#pragma once

#include "complex/restraints.hh"
#include "complex/triangle_complex.hh"
#include "guard/guard.hh"
#include "loop/loop_context.hh"
#include "pairs/threshold_pair_sieve.hh"
#include "whittle/engine/host.hh"

namespace whittle {

/// The guards that the options, a host, if any, and the context ask for. A new guard gets a line in there.
Guards make_guards(TriangleComplex& complex, const Restraints& restraints, ThresholdPairSieve& sieve,
                   const DecimateOptions& options, DecimationHost* host, const LoopContext& context);

}  // namespace whittle
