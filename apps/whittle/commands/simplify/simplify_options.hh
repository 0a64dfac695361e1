#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "commands/page/report_options.hh"
#include "options/command_line.hh"
#include "options/targets.hh"
#include "whittle/pipeline/request.hh"

namespace whittle::app {

/// Where the contraction loop runs.
enum class Engine {
  flat,     ///< on the engine's arrays
  openmesh  ///< in OpenMesh's stock decimater, with the module of the same cost
};

/// The options of `whittle simplify`.
struct SimplifyCommand {
  std::vector<std::string> inputs;  ///< as on the command line
  std::string input;                ///< of one run
  std::string output;               ///< of one run; on the command line it may have `{stem}`
  Request request;
  FileOptions files;
  Engine engine = Engine::flat;
  // More files to write, each with `{stem}` as in `output`.
  std::optional<std::string> map;          ///< the vertex map
  std::optional<std::string> map_back;     ///< the vertex map from OUT to IN
  std::optional<std::string> certificate;  ///< the steps of the proof
  std::optional<std::string> recording;    ///< the steps of the run
  std::optional<std::string> curve;        ///< the error at the levels of the run
  std::optional<std::string> page;         ///< to look at the run
  std::optional<std::string> live;         ///< the page, from the beginning on
  FrameOptions pictures;                   ///< of the run
  bool embeds_input = true;                ///< whether the recording has the input in it
  bool compresses_recording = false;
  gltf::WriteOptions gltf;
  bool joins = false;  ///< whether all inputs are one mesh (`read_joined`)
  bool strict = false;
  std::vector<std::string> warnings;  ///< of options that do nothing
  CommonOptions common;
};

/// The request of one run, without its output.
Request request_of(const SimplifyCommand& run);

OptionRows simplify_rows(SimplifyCommand& options);

/// A file that a run can write besides the result.
struct SideFile {
  const char* option;
  std::optional<std::string>* path;
  const char* plural;  ///< of what it is
};
inline std::array<SideFile, 9> side_files(SimplifyCommand& options) {
  return {{{"--map", &options.map, "maps"},
           {"--map-back", &options.map_back, "maps"},
           {"--certificate", &options.certificate, "certificates"},
           {"--record", &options.recording, "recordings"},
           {"--curve", &options.curve, "curves"},
           {"--page", &options.page, "pages"},
           {"--live", &options.live, "pages"},
           {"--frames", &options.pictures.frames, "pictures"},
           {"--animate", &options.pictures.animation, "pictures"}}};
}

/// \throw UsageError for options that are missing or contradictory.
void check_options(const SimplifyCommand& options);

/// Warnings of options that do nothing as the others are.
std::vector<std::string> idle_options(const Given& given, const SimplifyCommand& options);

/// \throw UsageError if a format isn't told, if an output would overwrite an input or another output
/// \throw io::WriteError as `check_outputs`
void check_files(std::vector<SimplifyCommand> runs);

/// Key `options` of the report: every option except targets and options of printing.
nlohmann::ordered_json simplify_options_json(SimplifyCommand options);

}  // namespace whittle::app
