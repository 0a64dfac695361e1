#include "whittle/web/options.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

namespace whittle::web {
namespace {

using Set = void (*)(const GivenValue&, Settings&);

struct Option {
  std::string_view name;
  Set set;
};

[[noreturn]] void refuse(const char* valid) { throw std::invalid_argument(valid); }

/// \param words those that are valid, with | between, in the order of the enumeration
template <class Enum>
Enum word(const GivenValue& value, const char* words) {
  const std::string_view all = words;
  int number = 0;
  for (std::size_t begin = 0; begin <= all.size(); ++number) {
    const std::size_t end = std::min(all.find('|', begin), all.size());
    if (all.substr(begin, end - begin) == value.text) return static_cast<Enum>(number);
    begin = end + 1;
  }
  refuse(words);
}

double within(const GivenValue& value, double low, double high, const char* valid) {
  if (value.is_percent || !(value.number >= low && value.number <= high)) refuse(valid);
  return value.number;
}

double at_least_zero(const GivenValue& value) {
  return within(value, 0, std::numeric_limits<double>::infinity(), "a number, at least 0");
}

double angle(const GivenValue& value) {
  if (!(value.number > 0)) refuse("an angle in degrees, above 0, at most 180");
  return within(value, 0, 180, "an angle in degrees, above 0, at most 180");
}

std::uint64_t count(const GivenValue& value, double low) {
  const bool is_whole = std::floor(value.number) == value.number;
  constexpr double most = 9007199254740992;  // up to it all whole numbers are exact
  if (!is_whole) refuse("a whole number");
  return static_cast<std::uint64_t>(
      within(value, low, most, low > 0 ? "a whole number, at least 1" : "a whole number"));
}

double share(const GivenValue& value) {
  const double share = value.number / (value.is_percent ? 100 : 1);
  if (!(share > 0 && share < 1)) refuse("a share to keep: 0 < R < 1, or a percentage such as '30%'");
  return share;
}

GivenLength length(const GivenValue& value) {
  if (!(value.number >= 0)) refuse("a length: model units, or a percentage of the diagonal such as '1%'");
  return {value.number / (value.is_percent ? 100 : 1), value.is_percent};
}

GivenLength length_above_zero(const GivenValue& value) {
  if (!(value.number > 0)) refuse("a length above 0: model units, or a percentage of the diagonal such as '0.1%'");
  return length(value);
}

bool is_on(const GivenValue& value) { return word<int>(value, "false|true") == 1; }

/// "uv 0.03": one kind a call.
template <double AttributeWeights::*weight>
void set_weight(const GivenValue& value, Settings& settings) {
  settings.options.decimate.attribute_weights.*weight = at_least_zero(value);
}

constexpr std::array targets{
    Option{"faces", [](const GivenValue& v, Settings& s) { s.faces = count(v, 1); }},
    Option{"vertices", [](const GivenValue& v, Settings& s) { s.vertices = count(v, 1); }},
    Option{"ratio", [](const GivenValue& v, Settings& s) { s.ratio = share(v); }},
    Option{"face-ratio", [](const GivenValue& v, Settings& s) { s.face_ratio = share(v); }},
    Option{"max-cost", [](const GivenValue& v, Settings& s) { s.max_cost = at_least_zero(v); }},
    Option{"max-error", [](const GivenValue& v, Settings& s) { s.max_error = length_above_zero(v); }},
    Option{"max-error-borders", [](const GivenValue& v, Settings& s) { s.max_border_error = length_above_zero(v); }}};

constexpr std::array attributes{
    Option{"seams",
           [](const GivenValue& v, Settings& s) { s.options.decimate.seams = word<Seams>(v, "weighted|keep"); }},
    Option{"normals", [](const GivenValue& v,
                         Settings& s) { s.options.decimate.normals = word<Normals>(v, "keep|recompute|drop"); }},
    Option{"crease-angle", [](const GivenValue& v, Settings& s) { s.options.decimate.crease_angle_deg = angle(v); }},
    Option{"attribute-weight uv", set_weight<&AttributeWeights::texcoord>},
    Option{"attribute-weight normal", set_weight<&AttributeWeights::normal>},
    Option{"attribute-weight color", set_weight<&AttributeWeights::color>},
    Option{"attribute-weight morph", set_weight<&AttributeWeights::displacement>},
    Option{"attribute-weight joints", set_weight<&AttributeWeights::joint_weights>},
    Option{"attribute-weight seam", set_weight<&AttributeWeights::seam>}};

constexpr std::array pairs{
    Option{"threshold", [](const GivenValue& v, Settings& s) { s.threshold = length(v); }},
    Option{"max-pairs",
           [](const GivenValue& v, Settings& s) {
             const std::uint64_t n = std::min<std::uint64_t>(count(v, 0), 0xffffffff);
             s.options.decimate.pairs.max_pairs = n == 0 ? std::nullopt : std::optional(static_cast<unsigned>(n));
           }},
    Option{"across-walls", [](const GivenValue& v, Settings& s) { s.options.decimate.pairs.across_walls = is_on(v); }},
    Option{"topology",
           [](const GivenValue& v, Settings& s) { s.options.decimate.topology = word<Topology>(v, "keep|auto|free"); }},
    Option{"prune", [](const GivenValue& v, Settings& s) { s.prune = length(v); }}};

constexpr std::array costs{
    Option{"effort", [](const GivenValue& v, Settings& s) { s.effort = word<Effort>(v, "fast|normal|best"); }},
    Option{"cost",
           [](const GivenValue& v, Settings& s) {
             s.options.decimate.cost = word<Cost>(v, "quadric|memoryless|lindstrom-turk|midpoint");
           }},
    Option{"weights",
           [](const GivenValue& v, Settings& s) {
             s.options.decimate.quadric.weights = word<Weights>(v, "area|uniform|area-angle");
           }},
    Option{"placement",
           [](const GivenValue& v, Settings& s) {
             s.options.decimate.quadric.placement = word<Placement>(v, "optimal|midpoint|endpoint");
           }},
    Option{"valence", [](const GivenValue& v, Settings& s) { s.options.decimate.valence_weight = at_least_zero(v); }},
    Option{"isotropic",
           [](const GivenValue& v, Settings& s) { s.options.decimate.isotropy = within(v, 0, 1, "0 to 1"); }},
    Option{"order", [](const GivenValue& v,
                       Settings& s) { s.options.decimate.order = word<Order>(v, "automatic|exact|approximate"); }},
    Option{"polish",
           [](const GivenValue& v, Settings& s) {
             s.options.polish_passes = static_cast<unsigned>(std::min<std::uint64_t>(count(v, 0), 1000));
           }},
    Option{"fit", [](const GivenValue& v, Settings& s) { s.options.fit = word<Fit>(v, "mean|balanced|max"); }}};

constexpr std::array guards{
    Option{"boundary", [](const GivenValue& v,
                          Settings& s) { s.options.decimate.boundary = word<Boundary>(v, "weighted|locked|free"); }},
    Option{"boundary-weight",
           [](const GivenValue& v, Settings& s) { s.options.decimate.quadric.boundary_weight = at_least_zero(v); }},
    Option{"feature-angle",
           [](const GivenValue& v, Settings& s) {
             const double deg = angle(v);
             s.options.decimate.feature_angle_deg = deg == 180 ? std::nullopt : std::optional(deg);
           }},
    Option{"feature-tolerance", [](const GivenValue& v, Settings& s) { s.feature_tolerance = length(v); }},
    Option{"max-normal-flip",
           [](const GivenValue& v, Settings& s) { s.options.decimate.max_normal_flip_deg = angle(v); }},
    Option{"min-radius-ratio",
           [](const GivenValue& v, Settings& s) {
             const double ratio = within(v, 0, 1, "0 to 1");
             s.options.decimate.min_radius_ratio = ratio == 0 ? std::nullopt : std::optional(ratio);
           }},
    Option{"self-intersections", [](const GivenValue& v, Settings& s) {
             s.options.decimate.refuse_intersections = word<int>(v, "allow|refuse") == 1;
           }}};

constexpr std::array<std::span<const Option>, 5> groups{targets, attributes, pairs, costs, guards};

/// floor (share · n), as the pipeline's `share_of`: a product that is whole but for rounding counts as whole.
std::uint64_t share_of(double share, std::size_t n) {
  const double product = share * static_cast<double>(n);
  return static_cast<std::uint64_t>(std::floor(product * (1 + 4 * std::numeric_limits<double>::epsilon())));
}

}  // namespace

bool Settings::has_target() const { return faces || vertices || ratio || face_ratio || max_cost || max_error; }

DecimateTarget Settings::target(std::size_t n_vertices, std::size_t n_faces, double diagonal) const {
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  if (faces) target = target.or_faces(*faces);
  if (vertices) target = target.or_vertices(*vertices);
  if (max_cost) target = target.or_max_cost(*max_cost);
  if (max_error) {
    const GivenLength of_borders = max_border_error.value_or(*max_error);
    target = target.or_max_error(max_error->in_units(diagonal), of_borders.in_units(diagonal));
  }
  if (ratio) target = target.or_vertices(std::max(share_of(*ratio, n_vertices), target.n_vertices().value_or(0)));
  if (face_ratio) target = target.or_faces(std::max(share_of(*face_ratio, n_faces), target.n_faces().value_or(0)));
  return target;
}

void set_option(std::string_view name, const GivenValue& value, Settings& settings) {
  for (const std::span<const Option> group : groups) {
    for (const Option& option : group) {
      if (option.name == name) return option.set(value, settings);
    }
  }
  throw std::invalid_argument("there is no such option");
}

std::string_view option_names() {
  static const std::string names = [] {
    std::string all;
    for (const std::span<const Option> group : groups) {
      for (const Option& option : group) all.append(all.empty() ? "" : "\n").append(option.name);
    }
    return all;
  }();
  return names;
}

}  // namespace whittle::web
