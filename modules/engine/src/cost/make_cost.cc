#include "cost/make_cost.hh"

#include "cost/edge_length/isotropic_cost.hh"
#include "cost/edge_length/midpoint_cost.hh"
#include "cost/lindstrom_turk/lindstrom_turk_cost.hh"
#include "cost/memoryless/memoryless_cost.hh"
#include "cost/quadric/quadric_cost.hh"
#include "whittle/engine/formula/edge_length_term.hh"

namespace whittle {

QuadricOptions quadric_options(const DecimateOptions& options) {
  QuadricOptions quadric = options.quadric;
  if (options.boundary == Boundary::free) quadric.boundary_weight = 0;
  return quadric;
}

std::unique_ptr<PairCost> make_cost(TriangleComplex& complex, const Constraints& constraints,
                                    const DecimateOptions& options, bool has_threshold_pairs) {
  const QuadricOptions quadric = quadric_options(options);
  switch (options.effective_cost()) {
    case Cost::lindstrom_turk:
      return std::make_unique<LindstromTurkCost>(complex, constraints);
    case Cost::memoryless:
      return std::make_unique<MemorylessCost>(complex, constraints, quadric, has_threshold_pairs, options.threads);
    case Cost::midpoint:
      return std::make_unique<MidpointCost>(complex, constraints);
    case Cost::quadric:
      break;
  }
  if (options.isotropy > 0) {
    return std::make_unique<IsotropicCost>(complex, constraints, quadric, options.isotropy, options.threads);
  }
  return std::make_unique<QuadricCost>(complex, constraints, quadric, has_threshold_pairs, options.threads);
}

bool places_anywhere(const DecimateOptions& options) {
  return options.effective_cost() != Cost::midpoint && options.quadric.placement == Placement::optimal;
}

double cost_dimension(const DecimateOptions& options) {
  const double by_area = cost_traits(options.effective_cost()).dimension;
  if (options.effective_cost() != Cost::quadric) return by_area;
  return isotropic_dimension(options.quadric.weights == Weights::uniform ? 2 : by_area, options.isotropy);
}

}  // namespace whittle
