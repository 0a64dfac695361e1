#include "whittle/verify/verify.hh"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "options/targets.hh"
#include "system/system.hh"
#include "terminal/table.hh"
#include "whittle/core/detail/cores.hh"
#include "whittle/core/flat_arrays.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/path_of.hh"
#include "whittle/io/whole_file.hh"

namespace whittle::app {
namespace {

struct VerifyCommand {
  std::string input;
  std::string output;
  std::string certificate;
  FileOptions files;                       ///< the length to weld to is that of IN
  std::optional<Length> max_error;         ///< that is to be proven
  std::optional<Length> max_border_error;  ///< that is to be proven of the open borders
  CommonOptions common;
};

struct VerifyRun {
  Input input;
  Input output;
  std::string certificate;  ///< its bytes
  double diagonal = 0;      ///< of the input's bounding box
  verify::Verification verification;
  double verify_seconds = 0;
};

/// OUT, as the run that wrote it has read it again: --weld is for IN.
Input read_output(const VerifyCommand& options, const Talk& talk) {
  FileOptions files = options.files;
  files.weld_tolerance = {};
  return read_input(options.output, files, options.common.threads, talk);
}

verify::Triangles triangles_of(const Scene& input) {
  return {flat_positions(input.read.mesh), flat_faces(input.read.mesh)};
}

VerifyRun verify_files(const VerifyCommand& options, const Talk& talk) {
  VerifyRun run;
  run.certificate = io::read_file(io::path_of(options.certificate), options.certificate);
  run.input = read_input(options.input, options.files, options.common.threads, talk);
  run.output = read_output(options, talk);
  run.diagonal = diagonal_of(bounds_of(run.input.read.mesh));
  const Stopwatch watch;
  const unsigned threads = options.common.threads > 0 ? options.common.threads : detail::n_cores();
  run.verification = verify::verify(triangles_of(run.input), triangles_of(run.output), run.certificate, threads);
  run.verify_seconds = watch.seconds();
  return run;
}

/// A requested distance, model units.
std::optional<double> asked(const std::optional<Length>& length, const VerifyRun& run) {
  return length ? std::optional(length->in_units(run.diagonal)) : std::nullopt;
}

/// "0.1 (0.5 %)"
std::string distance_text(double distance, const VerifyRun& run) {
  return length_text_rounded_up(distance, run.diagonal);
}

/// The difference between the request and the proof; empty if the proof suffices. \param what "of borders "
std::string shortfall(const std::optional<Length>& length, double proven, const std::string& what,
                      const VerifyRun& run) {
  if (!length || proven <= *asked(length, run)) return {};
  const std::string asked_text = distance_text(*asked(length, run), run) + " is asked " + what + "at most, and ";
  return asked_text + (std::isfinite(proven) ? distance_text(proven, run) : "nothing") + " is proven";
}

/// The problem in a line, or empty.
std::string problem(const VerifyCommand& options, const VerifyRun& run) {
  const verify::Verification& proof = run.verification;
  if (proof.is_malformed) return "no whole certificate: " + proof.why_not;
  if (!proof.holds) return "does not hold for " + run.input.name + " and " + run.output.name + ": " + proof.why_not;
  const std::string of_surface = shortfall(options.max_error, proof.max_error, "", run);
  return of_surface.empty() ? shortfall(options.max_border_error, proof.max_error_borders, "of borders ", run)
                            : of_surface;
}

/// Adds a distance that is proven; null if nothing is. \param key "max_error"
void add_proven(Json& json, const std::string& key, double distance, const VerifyRun& run) {
  json[key] = nullptr;
  json[key + "_rel"] = nullptr;
  if (run.verification.holds && std::isfinite(distance)) add_length(json, key, distance, run.diagonal);
}

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json verify_json(const VerifyCommand& options, const VerifyRun& run, bool is_met, double total_seconds) {
  const verify::Verification& proof = run.verification;
  Json json = new_report();
  json["input"] = input_json(run.input, run.diagonal);
  json["output"] = input_json(run.output, diagonal_of(bounds_of(run.output.read.mesh)));
  json["certificate"] = {{"path", options.certificate}, {"bytes", run.certificate.size()}};
  json["holds"] = proof.holds;
  add_proven(json, "max_error", proof.max_error, run);
  add_proven(json, "max_error_borders", proof.max_error_borders, run);
  json["tolerances"] = proof.tolerances.size();
  json["malformed"] = proof.is_malformed;
  json["why_not"] = proof.holds ? Json(nullptr) : Json(proof.why_not);
  json["asked"] = {{"max_error", or_null(asked(options.max_error, run))},
                   {"max_error_borders", or_null(asked(options.max_border_error, run))},
                   {"met", is_met}};
  json["seconds"] = {
      {"read", run.input.seconds + run.output.seconds}, {"verify", run.verify_seconds}, {"total", total_seconds}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  std::vector<std::string> warnings = run.input.warnings;
  warnings.insert(warnings.end(), run.output.warnings.begin(), run.output.warnings.end());
  json["warnings"] = warnings;
  return json;
}

/// The proven distances, in words.
std::string proven_text(const VerifyRun& run) {
  const verify::Verification& proof = run.verification;
  const std::string& in = run.input.name;
  const std::string& out = run.output.name;
  const auto within = [&](const std::string& of_in, const std::string& of_out, double distance) {
    return "each point of " + of_in + " is within " + distance_text(distance, run) + " of " + of_out +
           ", and each point of " + of_out + " of " + of_in + '\n';
  };
  std::string text = "the certificate holds\n";
  if (std::isfinite(proof.max_error)) text += within(in, out, proof.max_error);
  if (std::isfinite(proof.max_error_borders)) {
    text += within("the border of " + in, "the border of " + out, proof.max_error_borders);
  } else {
    text += "nothing is proven of borders\n";
  }
  if (proof.tolerances.empty()) return text;
  return text + counted(proof.tolerances.size(), "vertex of ", "vertices of ") + in +
         " with a tolerance: each point of a face of " + in + " is within the least of its corners' of " + out +
         ", and each point of " + out + " within that of some face of " + in + '\n';
}

void check(const VerifyCommand& options) {
  check_formats({options.input, options.output}, {}, options.files);
  if (!options.common.json) return;
  check_outputs({{"--json", *options.common.json}}, {options.input, options.output, options.certificate},
                options.common.force);
}

ExitCode run_verify(const Given& /*given*/, VerifyCommand options) {
  check(options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  const VerifyRun run = verify_files(options, talk);
  const std::string wrong = problem(options, run);
  write_report(
      options.common, [&] { return verify_json(options, run, wrong.empty(), watch.seconds()); },
      run.verification.holds ? proven_text(run) : std::string());
  talk.detail("read " + seconds_text(run.input.seconds + run.output.seconds) + ", verify " +
              seconds_text(run.verify_seconds));
  say_effort(talk, watch.seconds());
  if (wrong.empty()) return ExitCode::done;
  talk.error(about(options.certificate, wrong));
  return run.verification.is_malformed ? ExitCode::unreadable : ExitCode::failure;
}

OptionRows verify_rows(VerifyCommand& options) {
  OptionRows rows{file_argument("IN", options.input, "the mesh that was simplified, or '-' for standard input"),
                  file_argument("OUT", options.output, "the result, or '-' for standard input"),
                  file_argument("CERT", options.certificate, "what 'simplify --certificate' has written")};
  rows.back().access.meta = "FILE";
  append(rows, {{.names = "-e,--max-error",
                 .access = length_above_zero(options.max_error),
                 .help = "fail if a larger distance than E is all that is proven: model units, or a percentage of the "
                         "diagonal such as 0.1%"},
                {.names = "--max-error-borders",
                 .access = length_above_zero(options.max_border_error),
                 .help = "likewise for the distance between the open borders"}});
  append(rows, input_rows(options.files));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_verify(CLI::App& app, Command& command) {
  const SubcommandText text{"verify", "Check a certificate of 'simplify': how far OUT is from IN at most.",
                            "IN OUT CERT [OPTION]...",
                            "Examples:\n"
                            "  whittle simplify dragon.ply -o small.ply --max-error 0.1% --certificate small.proof\n"
                            "  whittle verify dragon.ply small.ply small.proof --max-error 0.1%"};
  VerifyCommand defaults;
  defaults.files.reads_documents = true;
  defaults.files.scope = SceneScope::scene;
  add_subcommand(app, text, defaults, verify_rows, run_verify, command);
}

}  // namespace whittle::app
