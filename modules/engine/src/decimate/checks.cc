#include "decimate/checks.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "whittle/core/detail/checks.hh"

namespace whittle {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("decimate: ") + what);
}

bool is_finite_and_not_negative(double x) { return x >= 0 && std::isfinite(x); }

void check_ranges(const DecimateOptions& options) {
  const QuadricOptions& quadric = options.quadric;
  require(is_finite_and_not_negative(quadric.regularization), "regularization is negative or not finite");
  require(is_finite_and_not_negative(quadric.boundary_weight), "boundary_weight is negative or not finite");
  require(is_finite_and_not_negative(quadric.point_weight), "point_weight is negative or not finite");
  const auto is_angle = [](const std::optional<double>& degrees) {
    return !degrees || (*degrees > 0 && *degrees <= 180);
  };
  require(is_angle(options.max_normal_flip_deg), "max_normal_flip_deg is not in (0, 180]");
  require(is_angle(options.feature_angle_deg), "feature_angle_deg is not in (0, 180]");
  require(is_angle(options.crease_angle_deg), "crease_angle_deg is not in (0, 180]");
  require(options.feature_tolerance >= 0, "feature_tolerance is negative or not a number");
  require(options.isotropy >= 0 && options.isotropy <= 1, "isotropy is not in [0, 1]");
  const AttributeWeights& weights = options.attribute_weights;
  for (const double weight :
       {weights.texcoord, weights.normal, weights.color, weights.displacement, weights.joint_weights, weights.seam}) {
    require(is_finite_and_not_negative(weight), "an attribute weight is negative or not finite");
  }
  require(is_finite_and_not_negative(options.valence_weight), "valence_weight is negative or not finite");
  const double min_radius_ratio = options.min_radius_ratio.value_or(0);
  require(min_radius_ratio >= 0 && min_radius_ratio <= 1, "min_radius_ratio is not in [0, 1]");
  require(options.pairs.threshold.value_or(0) >= 0, "pairs.threshold is negative or not a number");
  require(options.pairs.max_pairs != 0, "pairs.max_pairs is 0; empty takes all");
}

/// Options that are at their defaults count as not given.
void check_conflicts(const DecimateOptions& options) {
  const auto refuse = [](bool is_given, const char* option, std::string_view other, std::string_view why) {
    if (!is_given || why.empty()) return;
    throw std::invalid_argument("decimate: " + std::string(option) + " doesn't go with " + std::string(other) + ": " +
                                std::string(why));
  };
  const CostTraits& traits = cost_traits(options.effective_cost());
  const std::string cost = "the cost " + std::string(traits.name);
  const QuadricOptions& quadric = options.quadric;
  const QuadricOptions standard;
  const bool has_pairs = options.pairs.threshold > 0;
  const bool has_boundary_weight = quadric.boundary_weight != standard.boundary_weight;
  refuse(quadric.weights != standard.weights, "weights", cost, traits.why_not.weights);
  refuse(quadric.placement != standard.placement, "placement", cost, traits.why_not.placement);
  refuse(has_boundary_weight, "boundary_weight", cost, traits.why_not.boundary_weight);
  refuse(quadric.regularization != standard.regularization, "regularization", cost, traits.why_not.regularization);
  refuse(options.isotropy > 0, "isotropy", cost, traits.why_not.isotropy);
  refuse(options.valence_weight > 0, "valence_weight", cost, traits.why_not.valence_weight);
  refuse(has_pairs, "pairs.threshold", cost, traits.why_not.threshold);
  refuse(has_pairs && options.effective_order() == Order::exact, "pairs.threshold in exact order", cost,
         traits.why_not.threshold_in_exact_order);
  refuse(has_pairs && options.isotropy > 0, "pairs.threshold", "isotropy", plain_quadrics_alone);
  refuse(has_pairs && options.valence_weight > 0, "pairs.threshold", "valence_weight", plain_quadrics_alone);
  refuse(has_boundary_weight && options.boundary == Boundary::free, "boundary_weight", "free borders",
         free_borders_have_no_weight);
}

void check_pauses(const DecimateOptions& options) {
  const std::vector<double>& at = options.pauses.at;
  const auto is_multiple = [](double factor) { return factor > 1 && std::isfinite(factor); };
  require(std::all_of(at.begin(), at.end(), is_multiple), "a pause is not at a multiple above 1");
  require(std::is_sorted(at.rbegin(), at.rend()), "pauses are not in descending order");
  require(at.empty() || options.pauses.adjust, "there are pauses, but nothing to do there");
  require(at.empty() || options.quadric.placement != Placement::endpoint,
          "pauses don't go with Placement::endpoint: vertices would leave their places");
}

}  // namespace

void check(const DecimateTarget& target, const DecimateOptions& options, std::size_t n_vertices) {
  require(is_finite_and_not_negative(target.cost_limit().value_or(0)), "max_cost is negative or not finite");
  for (const double max_error : {target.error_limit().value_or(1), target.border_error_limit().value_or(1)}) {
    require(max_error > 0 && std::isfinite(max_error), "max_error is not positive or not finite");
  }
  check_ranges(options);
  check_conflicts(options);
  check_pauses(options);
  const std::vector<double>& tolerances = options.tolerances;
  require(tolerances.empty() || target.error_limit(), "there are tolerances, but no max_error");
  require(tolerances.empty() || tolerances.size() == n_vertices, "tolerances has another length than the vertices");
  require(std::all_of(tolerances.begin(), tolerances.end(), [](double t) { return t > 0; }),
          "a tolerance is not positive");
  require(options.locked.empty() || options.locked.size() == n_vertices, "locked has another length than the vertices");
  const auto is_there = [n_vertices](const VertexPair& edge) { return std::max(edge.a, edge.b) < n_vertices; };
  require(std::all_of(options.feature_edges.begin(), options.feature_edges.end(), is_there),
          "a feature edge names a vertex that isn't there");
}

void check(const IndexedMesh& mesh) {
  if (mesh.faces.size() > (std::size_t{1} << 31)) throw std::length_error("decimate: more than 2^31 faces");
  if (mesh.positions.size() >= invalid_index) throw std::length_error("decimate: more than 2^32 - 2 vertices");
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) {
      if (v < mesh.positions.size()) continue;
      throw std::invalid_argument("decimate: face " + std::to_string(&face - mesh.faces.data()) + " names vertex " +
                                  std::to_string(v) + " of " + std::to_string(mesh.positions.size()));
    }
  }
  check_positions(mesh.positions, "decimate");
  check_attributes(mesh, "decimate");
}

}  // namespace whittle
