#pragma once

#include <memory>

#include "complex/constraints.hh"
#include "cost/pair_cost.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {

/// The cost that the options ask for. A new cost gets a line in there.
/// \param has_threshold_pairs whether there are pairs beside the edges \pre the complex lists faces
std::unique_ptr<PairCost> make_cost(TriangleComplex& complex, const Constraints& constraints,
                                    const DecimateOptions& options, bool has_threshold_pairs);

/// What costs know of the options of quadrics.
QuadricOptions quadric_options(const DecimateOptions& options);

/// Whether the cost puts merged vertices anywhere, not at vertices or in the middle of edges alone.
bool places_anywhere(const DecimateOptions& options);

/// The power of a length that is the unit of the cost that the options ask for.
double cost_dimension(const DecimateOptions& options);

}  // namespace whittle
