#include "fuzz/decode/decimate_bytes.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "fuzz/decode/mesh_bytes.hh"
#include "support/transforms.hh"
#include "whittle/core/detail/checks.hh"

namespace whittle::test {
namespace {

void set_quadric(QuadricOptions& quadric, ByteSource& source) {
  if (source.one_in(4)) quadric.weights = static_cast<Weights>(source.below(3));
  if (source.one_in(3)) quadric.placement = static_cast<Placement>(source.below(3));
  if (source.one_in(6)) quadric.regularization = option_value(source, 0, 1e-2);
  if (source.one_in(6)) quadric.boundary_weight = option_value(source, 0, 100);
  if (source.one_in(6)) quadric.point_weight = option_value(source, 0, 1);
}

void set_constraints(const IndexedMesh& mesh, DecimateOptions& options, ByteSource& source) {
  options.boundary = static_cast<Boundary>(source.below(3));
  if (source.one_in(3)) options.max_normal_flip_deg = source.one_in(2) ? 180 : option_value(source, 1, 180);
  if (source.one_in(6)) options.min_radius_ratio = option_value(source, 0, 1);
  if (source.one_in(5)) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) options.locked.push_back(source.one_in(4));
    if (source.one_in(32)) options.locked.push_back(1);
  }
  if (source.one_in(4)) options.feature_angle_deg = option_value(source, 5, 180);
  if (source.one_in(6)) options.feature_tolerance = option_value(source, 0, 1);
  if (source.one_in(5)) {
    for (int n = source.below(8); n > 0; --n) options.feature_edges.push_back({source.below(26), source.below(26)});
  }
  if (source.one_in(5)) {
    for (const Triangle& face : mesh.faces) {
      if (source.one_in(4)) options.feature_edges.push_back({face[0], face[1]});
    }
  }
}

void set_pairs(PairOptions& pairs, ByteSource& source) {
  if (!source.one_in(3)) return;
  pairs.threshold = source.one_in(16) ? std::numeric_limits<double>::infinity() : option_value(source, 0, 3);
  if (source.one_in(3)) pairs.max_pairs = source.below(6);
  if (source.one_in(8)) pairs.max_pairs.reset();
  pairs.across_walls = source.one_in(2);
}

DecimateTarget decoded_target(ByteSource& source) {
  const unsigned which = source.below(8);
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  if ((which & 1U) != 0) target = target.or_faces(source.below(64));
  if ((which & 2U) != 0) target = target.or_vertices(source.below(32));
  if (which >= 6) {
    const double cost = option_value(source, 0, 1);
    target = target.or_max_cost(std::ldexp(cost, -source.whole(0, 60)));
  }
  return target;
}

/// Reads from the end of the bytes: most have no limit of the error, as it takes long.
void set_error_limit(DecimateCase& c, ByteSource& source) {
  if (!source.one_in(8)) return;
  const double size = diagonal(c.mesh);
  const double max_error = option_value(source, 0, 0.2) * size;
  c.target = source.one_in(4) ? c.target.or_max_error(max_error, option_value(source, 0, 0.2) * size)
                              : c.target.or_max_error(max_error);
  if (!source.one_in(3)) return;
  for (std::size_t v = 0; v < c.mesh.positions.size(); ++v) {
    c.options.tolerances.push_back(option_value(source, 0.001, 0.3) * size);
  }
}

bool is_valid_error_limit(const DecimateCase& c) {
  const auto is_valid = [](double limit) { return limit > 0 && std::isfinite(limit); };
  const std::vector<double>& tolerances = c.options.tolerances;
  return is_valid(c.target.error_limit().value_or(1)) && is_valid(c.target.border_error_limit().value_or(1)) &&
         (tolerances.empty() || (c.target.error_limit() && tolerances.size() == c.mesh.positions.size())) &&
         std::all_of(tolerances.begin(), tolerances.end(), [](double tolerance) { return tolerance > 0; });
}

bool is_finite_and_not_negative(double x) { return x >= 0 && std::isfinite(x); }

bool is_in(const std::optional<double>& x, double low, double high) { return !x || (*x >= low && *x <= high); }

bool is_angle(const std::optional<double>& degrees) { return is_in(degrees, 0, 180) && degrees != 0.0; }

bool has_valid_ranges(const DecimateCase& c) {
  const DecimateOptions& options = c.options;
  return is_finite_and_not_negative(options.quadric.regularization) &&
         is_finite_and_not_negative(options.quadric.boundary_weight) &&
         is_finite_and_not_negative(options.quadric.point_weight) && is_angle(options.max_normal_flip_deg) &&
         is_angle(options.feature_angle_deg) && options.feature_tolerance >= 0 && is_in(options.isotropy, 0, 1) &&
         is_finite_and_not_negative(options.valence_weight) && is_in(options.min_radius_ratio, 0, 1) &&
         is_in(options.pairs.threshold, 0, std::numeric_limits<double>::infinity()) && options.pairs.max_pairs != 0U &&
         is_finite_and_not_negative(c.target.cost_limit().value_or(0)) && is_valid_error_limit(c) &&
         (options.locked.empty() || options.locked.size() == c.mesh.positions.size()) &&
         std::all_of(options.feature_edges.begin(), options.feature_edges.end(),
                     [&c](const VertexPair& edge) { return std::max(edge.a, edge.b) < c.mesh.positions.size(); });
}

/// Whether the options go with the cost, by its traits, and with each other.
bool has_no_conflict(const DecimateOptions& options) {
  const QuadricOptions& quadric = options.quadric;
  const CostConflicts& why_not = cost_traits(options.effective_cost()).why_not;
  const auto goes = [](bool is_set, std::string_view conflict) { return !is_set || conflict.empty(); };
  const bool has_pairs = options.pairs.threshold > 0;
  const bool has_boundary_weight = quadric.boundary_weight != QuadricOptions{}.boundary_weight;
  if (has_boundary_weight && options.boundary == Boundary::free) return false;
  if (has_pairs && (options.isotropy > 0 || options.valence_weight > 0)) return false;
  const bool has_exact_pairs = has_pairs && options.effective_order() == Order::exact;
  return goes(quadric.weights != Weights::area, why_not.weights) &&
         goes(quadric.placement != Placement::optimal, why_not.placement) &&
         goes(has_boundary_weight, why_not.boundary_weight) &&
         goes(quadric.regularization != QuadricOptions{}.regularization, why_not.regularization) &&
         goes(options.isotropy > 0, why_not.isotropy) && goes(options.valence_weight > 0, why_not.valence_weight) &&
         goes(has_pairs, why_not.threshold) && goes(has_exact_pairs, why_not.threshold_in_exact_order);
}

bool is_valid_mesh(const IndexedMesh& mesh) {
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), is_in_range);
}

}  // namespace

double option_value(ByteSource& source, double low, double high) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::array odd{
      std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, -1.0, -0.0, 1e300, 5e-324, 0.0};
  const std::uint8_t which = source.byte();
  if (which >= 248) return odd[which - 248U];
  return low + (high - low) * (which / 247.0);
}

DecimateCase decode_decimate_case(ByteSource& source) {
  DecimateCase c;
  c.target = decoded_target(source);
  DecimateOptions& options = c.options;
  options.threads = 1;
  if (source.one_in(2)) options.cost = static_cast<Cost>(source.below(all_cost_traits.size()));
  options.order = static_cast<Order>(source.below(3));
  options.topology = source.one_in(3) ? whittle::Topology::free : whittle::Topology::keep;
  if (source.one_in(8)) options.isotropy = option_value(source, 0, 1);
  if (source.one_in(8)) options.valence_weight = option_value(source, 0, 4);
  options.keep_quadrics = source.one_in(4);
  options.refuse_intersections = source.one_in(4);
  options.normals = static_cast<Normals>(source.below(3));
  if (source.one_in(16)) c.n_calls_left = source.below(4);
  set_quadric(options.quadric, source);
  set_pairs(options.pairs, source);
  c.mesh = decode_mesh(source);
  set_constraints(c.mesh, options, source);
  set_error_limit(c, source);
  return c;
}

bool is_valid(const DecimateCase& c) {
  return has_valid_ranges(c) && has_no_conflict(c.options) && is_valid_mesh(c.mesh);
}

std::string text_of(const DecimateCase& c) {
  const DecimateOptions& o = c.options;
  std::ostringstream text;
  const auto add = [&text](const char* name, const auto& value) { text << ' ' << name << ' ' << +value; };
  const auto add_optional = [&](const char* name, const auto& value) {
    if (value) add(name, *value);
  };
  text << "cost " << to_string(o.effective_cost());
  add("order", static_cast<int>(o.order));
  add("topology", static_cast<int>(o.topology));
  add("boundary", static_cast<int>(o.boundary));
  add("weights", static_cast<int>(o.quadric.weights));
  add("placement", static_cast<int>(o.quadric.placement));
  add("regularization", o.quadric.regularization);
  add("boundary_weight", o.quadric.boundary_weight);
  add("point_weight", o.quadric.point_weight);
  add("isotropy", o.isotropy);
  add("valence_weight", o.valence_weight);
  add("refuse_intersections", o.refuse_intersections);
  add("normals", static_cast<int>(o.normals));
  add_optional("threshold", o.pairs.threshold);
  add_optional("max_pairs", o.pairs.max_pairs);
  add("across_walls", o.pairs.across_walls);
  add_optional("max_normal_flip_deg", o.max_normal_flip_deg);
  add_optional("min_radius_ratio", o.min_radius_ratio);
  add_optional("feature_angle_deg", o.feature_angle_deg);
  add("feature_tolerance", o.feature_tolerance);
  add_optional("faces", c.target.n_faces());
  add_optional("vertices", c.target.n_vertices());
  add_optional("max_cost", c.target.cost_limit());
  add_optional("max_error", c.target.error_limit());
  add_optional("of borders", c.target.border_error_limit());
  add_optional("cancelled after", c.n_calls_left);
  text << "\nlocked";
  for (std::size_t v = 0; v < o.locked.size(); ++v) {
    if (o.locked[v] != 0) text << ' ' << v;
  }
  text << "\ntolerances";
  for (const double tolerance : o.tolerances) text << ' ' << tolerance;
  text << "\nfeatures";
  for (const auto& [a, b] : o.feature_edges) text << ' ' << a << '-' << b;
  return text.str() + '\n' + text_of(c.mesh);
}

}  // namespace whittle::test
