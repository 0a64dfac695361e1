#include "targets.hh"

#include <algorithm>

#include "command_line.hh"
#include "values.hh"

namespace whittle::app {
namespace {

std::uint64_t at_least_one(std::string_view text) { return parse_count(text); }

}  // namespace

void add_target_options(CLI::App& app, TargetOptions& options) {
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
  add_value(
      app, "--max-cost", "C", options.max_cost, [](std::string_view text) { return parse_number(text, {0}, "C"); },
      "contract nothing that costs more than C: distance squared times area in model units with plain quadrics "
      "(distance squared with uniform weights), a length to the fifth with memoryless ones, C >= 0")
      ->default_str("off")
      ->group(target_group);
}

void check_targets(const TargetOptions& options) {
  if (options.faces || options.vertices || options.ratio || options.max_cost) return;
  throw UsageError("no target: give at least one of --faces, --vertices, --ratio and --max-cost");
}

DecimateTarget resolve(const TargetOptions& options, std::uint64_t n_vertices) {
  DecimateTarget target{options.faces, options.vertices, options.max_cost};
  if (options.ratio) {
    const std::uint64_t kept = share_of(*options.ratio, n_vertices);
    target.vertices = std::max(kept, target.vertices.value_or(0));
  }
  return target;
}

bool is_met(const DecimateTarget& target, StopReason stop) {
  const bool has_count = target.faces || target.vertices;
  return stop == StopReason::target || stop == StopReason::cost || (stop == StopReason::exhausted && !has_count);
}

std::string to_string(const DecimateTarget& target) {
  std::string text;
  const auto add = [&text](const std::string& part) { text += (text.empty() ? "" : " or ") + part; };
  if (target.faces) add(std::to_string(*target.faces) + " faces");
  if (target.vertices) add(std::to_string(*target.vertices) + " vertices");
  if (target.max_cost) add("cost " + shortest(*target.max_cost));
  return text;
}

nlohmann::ordered_json target_json(const TargetOptions& options, const DecimateTarget& target) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (target.faces) json["faces"] = *target.faces;
  if (target.vertices) json["vertices"] = *target.vertices;
  if (options.ratio) json["ratio"] = *options.ratio;
  if (target.max_cost) json["max_cost"] = *target.max_cost;
  return json;
}

}  // namespace whittle::app
