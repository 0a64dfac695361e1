#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "options/command_line.hh"
#include "options/targets.hh"
#include "options/values.hh"
#include "whittle/engine/simplify.hh"

namespace whittle::app {

/// Where the contraction loop runs.
enum class Engine {
  flat,     ///< on the engine's arrays
  openmesh  ///< the module of the same cost in OpenMesh's stock decimater
};

/// How close vertices must be to be a pair without an edge.
struct ThresholdOption {
  bool is_automatic = false;  ///< chosen from the distances between the parts of the mesh
  Length length;              ///< otherwise this
};

/// What the command line asks for. Fields of `simplify` that depend on the mesh are filled in once it is read.
struct SimplifyCommand {
  std::string input;
  std::string output;
  TargetOptions targets;
  InputOptions reading;
  Effort effort = Effort::normal;
  SimplifyOptions simplify;
  ThresholdOption threshold;
  Length feature_tolerance{5e-4, true};  ///< how far feature lines may stray
  std::optional<Length> prune;           ///< parts smaller than this are dropped
  Engine engine = Engine::flat;
  std::optional<std::string> map;  ///< file for the vertex map
  bool strict = false;
  CommonOptions common;
};

/// With the cost, the passes and the flips filled in that the effort stands for.
SimplifyCommand settled(SimplifyCommand command);

void add_simplify_options(CLI::App& app, SimplifyCommand& options);

/// \throw UsageError for what is missing, contradictory, or would overwrite an input.
void check(const CLI::App& app, const SimplifyCommand& options);

/// Key `options` of the report: every option but the targets and those that say how much is printed.
nlohmann::ordered_json options_json(const SimplifyCommand& options);

}  // namespace whittle::app
