#include "loop/make_guards.hh"

#include "guard/areas/area_guard.hh"
#include "guard/constraint_guards.hh"
#include "guard/displacement_guard.hh"
#include "guard/flip_guard.hh"
#include "guard/hidden_pair_guard.hh"
#include "guard/intersection_guard.hh"
#include "guard/radius_ratio_guard.hh"
#include "guard/sharp_edge_guard.hh"
#include "guard/topology_guard.hh"
#include "host/host_guards.hh"

namespace whittle {

Guards make_guards(TriangleComplex& complex, const Constraints& constraints, ThresholdPairFilter& filter,
                   const StageContext& context) {
  const DecimateOptions& options = context.options;
  DecimationHost* const host = context.host;
  const StageLimits& limits = context.limits;
  Guards guards;
  const auto add = [&guards]<class G>(std::unique_ptr<G> guard) { guards.push_back(std::move(guard)); };
  if (constraints.any()) add(std::make_unique<LockedGuard>(constraints));
  if (constraints.any()) add(std::make_unique<FeatureLineGuard>(complex, constraints));
  if (complex.has_threshold_pairs()) add(std::make_unique<HiddenPairGuard>(complex, filter));
  add(std::make_unique<TopologyGuard>(complex, options.topology));
  if (host != nullptr && host->keeps_topology()) add(std::make_unique<NonmanifoldGuard>());
  add(std::make_unique<FlipGuard>(complex, options.effective_max_normal_flip_deg(), options.quadric));
  const double feature_angle_deg = options.feature_angle_deg.value_or(180);
  if (feature_angle_deg < 180) add(std::make_unique<SharpEdgeGuard>(complex, constraints, feature_angle_deg));
  if (options.min_radius_ratio > 0) add(std::make_unique<RadiusRatioGuard>(complex, *options.min_radius_ratio));
  if (options.refuse_intersections) add(std::make_unique<IntersectionGuard>(complex));
  if (host != nullptr && host->may_refuse()) add(std::make_unique<HostGuard>(complex, *host));
  if (limits.displacement)
    add(std::make_unique<DisplacementGuard>(complex, *limits.displacement, limits.displacements));
  if (!context.areas.of.empty()) add(std::make_unique<AreaGuard>(complex, context.areas));
  return guards;
}

}  // namespace whittle
