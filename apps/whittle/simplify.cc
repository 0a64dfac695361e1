#include <algorithm>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "errors.hh"
#include "input.hh"
#include "interruption.hh"
#include "openmesh_engine.hh"
#include "output.hh"
#include "progress_bar.hh"
#include "report.hh"
#include "simplify_options.hh"
#include "stopwatch.hh"
#include "subcommands.hh"
#include "table.hh"
#include "values.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/automatic_threshold.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/polish/polish.hh"

namespace whittle::app {
namespace {

struct Seconds {
  double read = 0;
  double decimate = 0;
  double polish = 0;
  double write = 0;
  double total = 0;
};

/// A run and what is said about it.
struct Run {
  Input input;
  DecimateTarget target;
  double diagonal = 0;  ///< of the input's bounding box
  std::size_t n_pruned_parts = 0;
  double threshold = 0;  ///< of pairs, model units
  Decimation decimation;
  PolishResult polish;
  bool met = false;
  std::vector<std::string> warnings;
  Seconds seconds;
};

/// Drops small parts from the input.
void prune(const SimplifyOptions& options, const Talk& talk, Run& run) {
  io::ReadResult& read = run.input.read;
  PrunedMesh pruned = without_small_parts(std::move(read.mesh), options.prune->in_units(run.diagonal));
  if (pruned.mesh.faces.empty()) {
    throw UnsupportedMesh(run.input.name + ": nothing is left without the parts smaller than " +
                          to_string(*options.prune) + "; choose a smaller --prune");
  }
  for (Index& v : read.vertex_map) v = v == invalid_index ? v : pruned.vertex_map[v];
  read.mesh = std::move(pruned.mesh);
  run.n_pruned_parts = pruned.n_dropped_parts;
  if (pruned.n_dropped_parts == 0) return;
  talk.say(run.input.name + ": dropped " + std::to_string(pruned.n_dropped_parts) + " small parts, " +
           std::to_string(pruned.n_dropped_faces) + " faces");
}

/// Model units.
double resolve_threshold(const SimplifyOptions& options, const Talk& talk, Run& run) {
  if (!options.threshold.is_automatic) return options.threshold.length.in_units(run.diagonal);
  const double threshold = automatic_threshold(run.input.read.mesh, options.common.threads);
  if (threshold == 0) {
    run.warnings.push_back(run.input.name +
                           ": no parts lie near one another, '--threshold auto' contracts edges alone");
    talk.warning(run.warnings.back());
  }
  return threshold;
}

Decimation decimate_input(const SimplifyOptions& options, const Talk& talk, const Run& run) {
  ProgressBar bar(talk, "decimating");
  DecimateOptions engine_options = options.decimate;
  engine_options.pairs.threshold = run.threshold;
  engine_options.max_normal_flip_deg = options.max_normal_flip();
  if (run.diagonal > 0) {
    engine_options.feature_tolerance = options.feature_tolerance.in_units(run.diagonal) / run.diagonal;
  }
  engine_options.threads = options.common.threads;
  engine_options.progress = [&bar](const Progress& progress) {
    bar.update(progress.fraction, std::to_string(progress.n_faces) + " faces");
    return !SignalsWait::pending();
  };
  const IndexedMesh& mesh = run.input.read.mesh;
  // OpenMesh is silent for too long while it fills its heap; and there is nothing to tidy up yet.
  if (options.engine == Engine::openmesh) return decimate_in_openmesh(mesh, run.input.name, run.target, engine_options);
  const SignalsWait signals_wait;
  Decimation decimation = decimate(mesh, run.target, engine_options);
  SignalsWait::throw_if_pending();
  return decimation;
}

void polish_result(const SimplifyOptions& options, Run& run) {
  const Stopwatch watch;
  const IndexedMesh& original = run.input.read.mesh;
  Decimation& decimation = run.decimation;
  PolishOptions polish_options{.passes = *options.polish_passes,
                               .flips = options.effort == Effort::best,
                               .fit_borders = options.decimate.boundary != Boundary::locked,
                               .features = decimation.feature_edges,
                               .min_radius_ratio = options.decimate.min_radius_ratio,
                               .threads = options.common.threads};
  if (options.decimate.feature_angle_deg < 180) polish_options.feature_angle_deg = options.decimate.feature_angle_deg;
  if (!decimation.feature_edges.empty()) {
    polish_options.original_features = feature_edges(original, options.decimate.feature_angle_deg);
  }
  const SignalsWait signals_wait;
  run.polish = polish(original, decimation.vertex_map, decimation.mesh, polish_options);
  SignalsWait::throw_if_pending();
  run.seconds.polish = watch.seconds();
}

/// A line for every vertex of the file: its number in the result, or -1.
void write_map(std::ostream& out, const Run& run) {
  for (const Index read : run.input.read.vertex_map) {
    const Index written = read == invalid_index ? invalid_index : run.decimation.vertex_map[read];
    if (written == invalid_index) {
      out << "-1\n";
    } else {
      out << written << '\n';
    }
  }
}

std::string advice(const SimplifyOptions& options, const Rejections& rejections) {
  if (options.engine == Engine::openmesh) return "--engine flat may get further";
  const auto& [link, flip, shape, feature, locked] = rejections;
  const std::uint64_t most = std::max({link, flip, shape, feature, locked});
  if (most == 0) return "nothing is left that may be contracted";
  if (most == feature) return "a greater --feature-angle or --feature-tolerance leaves more freedom";
  if (most == shape) return "a smaller --min-radius-ratio allows thinner faces";
  if (most == flip && options.max_normal_flip() < 180) {
    return "a greater --max-normal-flip lets faces turn further";
  }
  if (locked > link) return "'--boundary weighted' lets borders shrink";
  return "anything smaller would change the topology of the surface";
}

std::string refusals(const SimplifyOptions& options, const Rejections& refused) {
  if (options.engine == Engine::openmesh) return "OpenMesh doesn't say what it refused";
  std::string text = "refused: " + std::to_string(refused.link) + " by topology, " + std::to_string(refused.flip) +
                     " by turning a face, ";
  if (options.decimate.min_radius_ratio > 0) text += std::to_string(refused.shape) + " by shape, ";
  if (options.decimate.feature_angle_deg < 180) text += std::to_string(refused.feature) + " by features, ";
  return text + std::to_string(refused.locked) + " locked";
}

std::string shortfall(const SimplifyOptions& options, const Run& run) {
  const DecimateResult& result = run.decimation.result;
  return run.input.name + ": target not met: " + to_string(run.target) + " asked, " + std::to_string(result.n_faces) +
         " faces and " + std::to_string(result.n_vertices) + " vertices reached; " +
         refusals(options, result.rejections) + "; " + advice(options, result.rejections);
}

Json surface_json(const SurfaceCounts& counts) {
  return {{"components", counts.components},
          {"nonmanifold_edges", counts.nonmanifold_edges},
          {"nonmanifold_vertices", counts.nonmanifold_vertices}};
}

Json output_json(const SimplifyOptions& options, const Run& run, const metrics::Topology& topology) {
  Json json = {{"path", options.output}, {"vertices", topology.vertices}, {"faces", topology.faces}};
  add_topology(json, topology);
  json["vanished_components"] = run.decimation.result.n_vanished_components;
  json["pruned_components"] = run.n_pruned_parts;
  json["coincident_faces"] = run.decimation.result.n_coincident_faces;
  return json;
}

Json threshold_pairs_json(const ThresholdPairCounts& pairs) {
  return {{"considered", pairs.considered},
          {"contracted", pairs.contracted},
          {"threshold", pairs.threshold},
          {"capped", pairs.capped}};
}

/// OpenMesh's decimater doesn't say what it refused, and why.
Json rejections_json(const SimplifyOptions& options, const Rejections& refused) {
  if (options.engine == Engine::openmesh) {
    return {{"flip", nullptr}, {"link", nullptr}, {"shape", nullptr}, {"feature", nullptr}, {"locked", nullptr}};
  }
  return {{"flip", refused.flip},
          {"link", refused.link},
          {"shape", refused.shape},
          {"feature", refused.feature},
          {"locked", refused.locked}};
}

Json simplify_json(const SimplifyOptions& options, const Run& run) {
  const IndexedMesh& mesh = run.decimation.mesh;
  const DecimateResult& result = run.decimation.result;
  Json json = new_report();
  json["input"] = input_json(run.input, run.diagonal);
  if (options.engine == Engine::flat) json["input"].update(surface_json(result.before));
  json["options"] = options_json(options);
  json["output"] = output_json(options, run, metrics::topology(mesh));
  json["target"] = target_json(options.targets, run.target);
  json["target"]["met"] = run.met;
  json["stop"] = to_string(result.stop);
  json["contractions"] = result.n_contractions;
  json["threshold_pairs"] = threshold_pairs_json(result.threshold_pairs);
  json["max_cost"] = result.max_cost;
  json["rejections"] = rejections_json(options, result.rejections);
  json["polish"] = *options.polish_passes > 0 ? polish_json(run.polish) : Json(nullptr);
  json["seconds"] = {{"read", run.seconds.read},
                     {"decimate", run.seconds.decimate},
                     {"polish", run.seconds.polish},
                     {"write", run.seconds.write},
                     {"total", run.seconds.total}};
  json["peak_rss_bytes"] = peak_memory_bytes();
  json["warnings"] = run.warnings;
  return json;
}

/// The penalty for valences comes short of refusing.
void warn_of_valence_three(const SimplifyOptions& options, const Talk& talk, Run& run) {
  if (options.decimate.valence_weight == 0 || run.decimation.mesh.faces.empty()) return;
  std::size_t n_vertices = 0;
  for (const auto& [valence, count] : metrics::shape(run.decimation.mesh).valence.histogram) {
    if (valence <= 3) n_vertices += count;
  }
  if (n_vertices == 0) return;
  run.warnings.push_back(run.input.name + ": " + std::to_string(n_vertices) +
                         (n_vertices == 1 ? " vertex has" : " vertices have") +
                         " only three edges: they had them before, or nothing else was left to contract");
  talk.warning(run.warnings.back());
}

/// Writes the result, the map and the report; all of them appear, or none does.
void write_files(const SimplifyOptions& options, const Talk& talk, const Stopwatch& since_start, Run& run) {
  const Stopwatch watch;
  OutputFiles files;
  write_mesh(files, options.output, options.reading.format, run.decimation.mesh, talk, run.warnings);
  if (options.map) files.write(*options.map, [&run](std::ostream& out) { write_map(out, run); });
  run.seconds.write = watch.seconds();
  run.seconds.total = since_start.seconds();
  const std::string json = options.common.json ? to_text(simplify_json(options, run)) : std::string();
  commit_with_report(files, options.common, json);
}

std::string threshold_pairs(const ThresholdPairCounts& pairs) {
  return "threshold " + significant(pairs.threshold) + ": " + std::to_string(pairs.considered) + " pairs" +
         (pairs.capped ? ", the nearest of each vertex" : "") + ", " + std::to_string(pairs.contracted) + " contracted";
}

void say_details(const SimplifyOptions& options, const Talk& talk, const Run& run) {
  if (!talk.is_verbose()) return;
  const DecimateResult& result = run.decimation.result;
  talk.detail("contractions: " + std::to_string(result.n_contractions) + ", greatest cost " +
              significant(result.max_cost) + ", stopped by: " + std::string(to_string(result.stop)));
  talk.detail(refusals(options, result.rejections));
  if (run.threshold > 0) talk.detail(threshold_pairs(result.threshold_pairs));
  const bool is_polished = *options.polish_passes > 0;
  if (is_polished) talk.detail("polish: " + polish_text(run.polish));
  talk.detail("read " + seconds_text(run.seconds.read) + ", decimate " + seconds_text(run.seconds.decimate) +
              (is_polished ? ", polish " + seconds_text(run.seconds.polish) : "") + ", write " +
              seconds_text(run.seconds.write));
  say_effort(talk, run.seconds.total);
}

std::string summary(const SimplifyOptions& options, const Run& run) {
  const IndexedMesh& before = run.input.read.mesh;
  const DecimateResult& after = run.decimation.result;
  return shown_output(options.output) + ": " + std::to_string(before.faces.size()) + " -> " +
         std::to_string(after.n_faces) + " faces, " + std::to_string(before.positions.size()) + " -> " +
         std::to_string(after.n_vertices) + " vertices in " + seconds_text(run.seconds.total);
}

std::vector<std::string> lost_in_openmesh(const Input& input) {
  std::vector<std::string> warnings;
  const auto add = [&](const char* what) {
    warnings.push_back(input.name + ": " + what + " are not carried by --engine openmesh");
  };
  if (!input.read.mesh.normals.empty()) add("vertex normals");
  if (!input.read.mesh.colors.empty()) add("vertex colours");
  return warnings;
}

ExitCode run_simplify(const CLI::App& app, const SimplifyOptions& options) {
  check(app, options);
  const Talk talk(options.common.volume());
  const Stopwatch watch;
  Run run;
  run.input = read_input(options.input, options.reading, talk);
  run.seconds.read = run.input.seconds;
  run.warnings = run.input.warnings;
  if (options.engine == Engine::openmesh) {
    for (const std::string& lost : lost_in_openmesh(run.input)) {
      run.warnings.push_back(lost);
      talk.warning(lost);
    }
  }
  run.target = resolve(options.targets, run.input.read.mesh.positions.size());
  run.diagonal = metrics::bounds(run.input.read.mesh).diagonal();
  if (options.prune) prune(options, talk, run);

  const Stopwatch decimating;
  run.threshold = resolve_threshold(options, talk, run);
  run.decimation = decimate_input(options, talk, run);
  run.seconds.decimate = decimating.seconds();
  if (*options.polish_passes > 0) polish_result(options, run);
  run.met = is_met(run.target, run.decimation.result.stop);

  warn_of_valence_three(options, talk, run);
  const std::string missed = run.met ? std::string() : shortfall(options, run);
  if (!run.met) run.warnings.push_back(missed);
  write_files(options, talk, watch, run);

  say_details(options, talk, run);
  talk.say(summary(options, run));
  if (run.met) return ExitCode::done;
  if (!options.strict) {
    talk.warning(missed);
    return ExitCode::done;
  }
  talk.error(missed);
  return ExitCode::target_not_met;
}

}  // namespace

void setup_simplify(CLI::App& app, Command& command) {
  const auto options = std::make_shared<SimplifyOptions>();
  CLI::App* sub = app.add_subcommand("simplify", "Make a mesh smaller and keep its shape.");
  add_simplify_options(*sub, *options);
  set_usage(*sub, "IN -o OUT TARGET... [OPTION]...");
  sub->footer(
      "Examples:\n"
      "  whittle simplify dragon.ply -o small.ply --ratio 10%\n"
      "  whittle simplify part.stl -o part.obj --faces 5000 --strict --json report.json\n"
      "  whittle simplify - -o - --format ply --faces 5000 < in.ply > out.ply");
  sub->callback(
      [sub, options, &command] { command = [sub, options] { return run_simplify(*sub, settled(*options)); }; });
}

}  // namespace whittle::app
