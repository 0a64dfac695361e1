#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "command_line.hh"
#include "targets.hh"
#include "values.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// Where the contraction loop runs.
enum class Engine {
  flat,     ///< on the engine's arrays
  openmesh  ///< the module of the same cost in OpenMesh's stock decimater
};

/// What accuracy may take: a cost, and polishing.
enum class Effort { fast, normal, best };

/// How close vertices must be to be a pair without an edge.
struct ThresholdOption {
  bool is_automatic = false;  ///< chosen from the distances between the parts of the mesh
  Length length;              ///< otherwise this
};

struct SimplifyOptions {
  std::string input;
  std::string output;
  TargetOptions targets;
  InputOptions reading;
  Effort effort = Effort::normal;
  std::optional<Cost> cost;               ///< instead of the effort's
  std::optional<unsigned> polish_passes;  ///< instead of the effort's
  DecimateOptions decimate;
  ThresholdOption threshold;
  std::optional<double> max_normal_flip_deg;
  Length feature_tolerance{5e-4, true};  ///< how far feature lines may stray
  std::optional<Length> prune;           ///< parts smaller than this are dropped
  Engine engine = Engine::flat;
  std::optional<std::string> map;  ///< file for the vertex map
  bool strict = false;
  CommonOptions common;

  /// What it comes down to.
  Order order() const {
    if (decimate.order != Order::automatic) return decimate.order;
    return decimate.cost == Cost::memoryless ? Order::approximate : Order::exact;
  }
  double max_normal_flip() const { return max_normal_flip_deg.value_or(best_max_normal_flip_deg(decimate.cost)); }
};

/// With the cost and the passes filled in that the effort makes of the other options.
SimplifyOptions settled(SimplifyOptions options);

void add_simplify_options(CLI::App& app, SimplifyOptions& options);

/// \throw UsageError for what is missing, contradictory, or would overwrite an input.
void check(const CLI::App& app, const SimplifyOptions& options);

/// Key `options` of the report: every option but the targets and those of the conversation.
nlohmann::ordered_json options_json(const SimplifyOptions& options);

}  // namespace whittle::app
