#include "options/targets.hh"

#include <algorithm>
#include <stdexcept>

#include "options/command_line.hh"
#include "options/values.hh"
#include "terminal/table.hh"

namespace whittle::app {
namespace {

std::uint64_t at_least_one(std::string_view text) { return parse_count(text); }

Length above_zero(std::string_view text) {
  const Length length = parse_length(text, "E");
  if (!(length.value > 0)) throw std::invalid_argument("'" + std::string(text) + "' is not above 0");
  return length;
}

}  // namespace

void add_target_options(CLI::App& app, TargetOptions& options, const std::string& cost_unit) {
  add_value(app, "--faces", "N", options.faces, at_least_one, "stop at N faces or fewer, N >= 1")
      ->default_str("off")
      ->group(target_group);
  add_value(app, "--vertices", "N", options.vertices, at_least_one, "stop at N vertices or fewer, N >= 1")
      ->default_str("off")
      ->group(target_group);
  add_value(app, "-r,--ratio", "R", options.ratio, parse_ratio,
            "keep this share of the vertices, rounded down: 0 < R < 1, or a percentage such as 30%")
      ->default_str("off")
      ->group(target_group);
  add_value(app, "--face-ratio", "R", options.face_ratio, parse_ratio,
            "keep this share of the faces, rounded down: 0 < R < 1, or a percentage such as 30%")
      ->default_str("off")
      ->group(target_group);
  add_value(
      app, "--max-cost", "C", options.max_cost, [](std::string_view text) { return parse_number(text, {0}, "C"); },
      "contract nothing that costs more than C, C >= 0; " + cost_unit)
      ->default_str("off")
      ->group(target_group);
}

CLI::Option* add_length_above_zero(CLI::App& app, const std::string& names, std::optional<Length>& length,
                                   const std::string& description) {
  return add_value(app, names, "E", length, above_zero, description)->default_str("off");
}

void add_max_error(CLI::App& app, TargetOptions& options) {
  add_length_above_zero(app, "-e,--max-error", options.max_error,
                        "as few faces as keep each point of OUT within E of IN, and of IN within E of OUT, which is "
                        "proven: model units, or a percentage of the diagonal such as 0.1%")
      ->group(target_group);
  add_length_above_zero(app, "--max-error-borders", options.max_border_error,
                        "the same between the open borders of both")
      ->default_str("as --max-error")
      ->group(target_group);
  add_value(
      app, "--tolerance-map", "FILE", options.tolerances, [](std::string_view text) { return std::string(text); },
      "less than --max-error in places: a text with a length a line, of each vertex of IN")
      ->default_str("off")
      ->group(target_group);
}

void check_targets(const TargetOptions& options, const std::string& all) {
  const bool has_count = options.faces || options.vertices || options.ratio || options.face_ratio;
  if (has_count || options.max_cost || options.max_error) return;
  throw UsageError("no target: give at least one of " + all);
}

DecimateTarget resolve(const TargetOptions& options, std::uint64_t n_vertices, std::uint64_t n_faces, double diagonal) {
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  if (options.faces) target = target.or_faces(*options.faces);
  if (options.vertices) target = target.or_vertices(*options.vertices);
  if (options.max_cost) target = target.or_max_cost(*options.max_cost);
  if (options.max_error) {
    const Length of_borders = options.max_border_error.value_or(*options.max_error);
    target = target.or_max_error(options.max_error->in_units(diagonal), of_borders.in_units(diagonal));
  }
  if (options.ratio) {
    const std::uint64_t kept = share_of(*options.ratio, n_vertices);
    target = target.or_vertices(std::max(kept, target.n_vertices().value_or(0)));
  }
  if (options.face_ratio) {
    const std::uint64_t kept = share_of(*options.face_ratio, n_faces);
    target = target.or_faces(std::max(kept, target.n_faces().value_or(0)));
  }
  return target;
}

bool is_met(const DecimateTarget& target, StopReason stop) {
  const bool has_count = target.n_faces() || target.n_vertices();
  return stop == StopReason::target || (stop != StopReason::cancelled && !has_count);
}

DecimateTarget counts_of(const DecimateTarget& target) {
  DecimateTarget counts = DecimateTarget::as_far_as_possible();
  if (target.n_faces()) counts = counts.or_faces(*target.n_faces());
  if (target.n_vertices()) counts = counts.or_vertices(*target.n_vertices());
  return counts;
}

std::string_view option_that_ended(StopReason stop) {
  if (stop == StopReason::error) return "--max-error";
  return stop == StopReason::cost ? "--max-cost" : "";
}

std::string to_string(const DecimateTarget& target) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : " or ") + part; };
  if (target.n_faces()) add(faces_text(*target.n_faces()));
  if (target.n_vertices()) add(vertices_text(*target.n_vertices()));
  if (target.cost_limit()) add("cost " + shortest(*target.cost_limit()));
  if (target.error_limit()) add("error " + shortest(*target.error_limit()));
  return text;
}

nlohmann::ordered_json target_json(const TargetOptions& options, const DecimateTarget& target) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (target.n_faces()) json["faces"] = *target.n_faces();
  if (target.n_vertices()) json["vertices"] = *target.n_vertices();
  if (options.ratio) json["ratio"] = *options.ratio;
  if (options.face_ratio) json["face_ratio"] = *options.face_ratio;
  if (target.cost_limit()) json["max_cost"] = *target.cost_limit();
  if (target.error_limit()) json["max_error"] = *target.error_limit();
  if (options.max_border_error && target.border_error_limit()) json["max_error_borders"] = *target.border_error_limit();
  if (options.tolerances) json["tolerance_map"] = *options.tolerances;
  return json;
}

}  // namespace whittle::app
