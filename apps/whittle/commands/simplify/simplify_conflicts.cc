#include "commands/simplify/simplify_options.hh"

#include <iterator>
#include <string>
#include <string_view>

#include "whittle/engine/cost_traits.hh"

namespace whittle::app {
namespace {

/// Adds the options that a cost doesn't take, in the order in which conflicts are reported.
void add_cost_conflicts(const CostTraits& traits, std::vector<Conflict>& conflicts) {
  const auto add = [&](const char* option, std::string_view why) {
    if (!why.empty()) conflicts.push_back({option, "--cost " + std::string(traits.name), std::string(why)});
  };
  const CostConflicts& why = traits.why_not;
  add("--weights uniform", why.weights);
  add("--weights area-angle", why.weights);
  add("--placement midpoint", why.placement);
  add("--placement endpoint", why.placement);
  add("--boundary-weight", why.boundary_weight);
  add("--isotropic", why.isotropy);
  add("--valence", why.valence_weight);
  add("--threshold", why.threshold);
}

}  // namespace

std::vector<Conflict> simplify_conflicts() {
  std::vector<Conflict> all;
  for (const CostTraits& traits : all_cost_traits) add_cost_conflicts(traits, all);
  const std::string edges_alone(plain_quadrics_alone);
  const std::string no_pairs = "OpenMesh's decimater contracts edges alone";
  const std::string own_order = "OpenMesh's decimater has an order of its own";
  const Conflict more[] = {
      {"--threshold", "--isotropic", edges_alone},
      {"--threshold", "--valence", edges_alone},
      {"--boundary-weight", "--boundary free", std::string(free_borders_have_no_weight)},
      {"--order exact", "--engine openmesh", own_order},
      {"--order approximate", "--engine openmesh", own_order},
      {"--max-cost", "--engine openmesh", "OpenMesh looks at a cost when it is queued, not when its turn comes"},
      {"--certificate", "--join", "'verify' reads one IN"},
      {"--no-embed", "--join", "'replay' reads one IN"},
      {"--certificate", "--prune", "the proof is about all of IN"},
      {"--no-embed", "--prune", "the recording is of IN without its small parts"},
      {"--tolerance-map", "--prune", "the lengths are of all vertices of IN"},
      {"--threshold", "--engine openmesh", no_pairs},
      {"--max-pairs", "--engine openmesh", no_pairs},
      {"--across-walls", "--engine openmesh", no_pairs},
      {"--per-mesh", "--max-error", "the error is that of each mesh in any case"},
      {"--per-mesh", "--attributes position-only", "nothing would say which mesh a face is of"},
      {"--topology free", "--engine openmesh", "a half-edge mesh keeps its topology"}};
  all.insert(all.end(), std::begin(more), std::end(more));
  for (const char* option : {"--record", "--curve", "--page", "--frames", "--animate"}) {
    all.push_back({"--per-mesh", option, "each mesh has a run of its own"});
  }
  for (const char* option : {"--feature-angle", "--feature-tolerance", "--min-radius-ratio", "--max-error", "--record",
                             "--curve", "--page", "--frames", "--animate", "--self-intersections refuse"}) {
    all.push_back({option, "--engine openmesh", "only Whittle's own loop does that"});
  }
  return all;
}

}  // namespace whittle::app
