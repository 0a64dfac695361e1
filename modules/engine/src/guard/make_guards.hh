#pragma once

#include "complex/triangle_complex.hh"
#include "guard/guard.hh"
#include "guard/restraints.hh"
#include "pairs/threshold_pair_sieve.hh"

namespace whittle {

/// The guards that the options ask for. A new guard gets a line in there.
Guards make_guards(TriangleComplex& complex, const Restraints& restraints, ThresholdPairSieve& sieve,
                   const DecimateOptions& options);

}  // namespace whittle
