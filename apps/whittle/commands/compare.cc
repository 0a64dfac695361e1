#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/stage_bars.hh"
#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "openmesh/stock_decimater.hh"
#include "options/sampling.hh"
#include "options/targets.hh"
#include "terminal/interruption.hh"
#include "terminal/progress_bar.hh"
#include "terminal/table.hh"
#include "whittle/core/progress.hh"
#include "whittle/pipeline/request.hh"

namespace whittle::app {
namespace {

struct CompareOptions {
  std::string input;
  Targets targets;
  FileOptions files;
  std::optional<Effort> effort;  ///< if not given: normal, or fast with a cost limit
  metrics::DistanceOptions distance;
  CommonOptions common;
};

/// One side of the comparison.
struct Contender {
  std::size_t n_vertices = 0;
  std::size_t n_faces = 0;
  double decimate_seconds = 0;
  double polish_seconds = 0;
  metrics::SurfaceDistance distance;  ///< from the input

  bool is_met = true;  ///< the target; under a cost limit always

  double seconds() const { return decimate_seconds + polish_seconds; }
};

struct Comparison {
  DecimateTarget target = DecimateTarget::as_far_as_possible();
  Effort effort = Effort::normal;
  SimplifyOptions settled;  ///< options of the effort
  Contender ours;
  Contender stock;
  double stock_seconds_build = 0;
  std::uint64_t stock_lost_faces = 0;
};

/// Plain quadrics with a cost limit: OpenMesh's limit has their unit.
Effort effective_effort(const CompareOptions& options) {
  return options.effort.value_or(options.targets.max_cost ? Effort::fast : Effort::normal);
}

/// Other efforts than fast, whose cost has another unit than OpenMesh's limit.
std::vector<OptionConflict> conflicts_of_effort() {
  const std::string why = "OpenMesh's limit has the unit of '--effort fast'";
  return {{"normal", "--max-cost", why}, {"best", "--max-cost", why}};
}

/// A contender without its times.
Contender judged(const IndexedMesh& input, const IndexedMesh& result, const DecimateTarget& target,
                 const CompareOptions& options) {
  metrics::DistanceOptions distance = options.distance;
  distance.threads = options.common.threads;
  Contender contender;
  contender.n_vertices = result.positions.size();
  contender.n_faces = result.faces.size();
  contender.is_met = target.cost_limit() || target.is_reached_at(contender.n_faces, contender.n_vertices);
  contender.distance = metrics::surface_distance(input, result, distance);
  return contender;
}

Contender run_ours(const IndexedMesh& input, const Comparison& comparison, const CompareOptions& options,
                   const Talk& talk) {
  Simplification simplified;
  {
    StageBars bars(talk);
    SimplifyOptions library_options = comparison.settled;
    library_options.decimate.threads = options.common.threads;
    library_options.decimate.progress = [&bars](const Progress& progress) { return bars.update(progress); };
    simplified = simplify(input, comparison.target, comparison.effort, library_options);
  }
  Contender ours = judged(input, simplified.mesh, comparison.target, options);
  ours.decimate_seconds = simplified.decimate_seconds;
  ours.polish_seconds = simplified.polish_seconds;
  return ours;
}

StockRun run_stock(const Scene& input, const DecimateTarget& target, std::size_t expected_contractions,
                   const Talk& talk) {
  ProgressBar bar(talk, "OpenMesh ModQuadric");
  return decimate_by_stock(input.read.mesh, input.name, target, [&](std::uint64_t n_contractions) {
    const auto done =
        static_cast<double>(n_contractions) / static_cast<double>(std::max<std::size_t>(expected_contractions, 1));
    bar.update(done, std::to_string(n_contractions) + " contractions");
  });
}

Comparison compare(const Scene& input, const CompareOptions& options, const Talk& talk) {
  const IndexedMesh& mesh = input.read.mesh;
  Comparison comparison;
  comparison.target = resolve(options.targets, mesh.positions.size(), mesh.faces.size(), 0);
  comparison.effort = effective_effort(options);
  comparison.settled = with_effort(comparison.effort, {}, mesh, comparison.target);
  comparison.ours = run_ours(mesh, comparison, options, talk);
  const std::size_t expected = mesh.positions.size() - comparison.ours.n_vertices;
  const StockRun stock = run_stock(input, comparison.target, expected, talk);
  comparison.stock = judged(mesh, stock.mesh, comparison.target, options);
  comparison.stock.decimate_seconds = stock.seconds_decimate;
  comparison.stock_seconds_build = stock.seconds_build;
  comparison.stock_lost_faces = stock.n_lost_faces;
  return comparison;
}

Json contender_json(const Contender& contender, const char* name) {
  Json json = {{"name", name}, {"vertices", contender.n_vertices}, {"faces", contender.n_faces}};
  json["met"] = contender.is_met;
  json["seconds"] = {{"decimate", contender.decimate_seconds}};
  add_distance(json, contender.distance);
  return json;
}

/// The options of both runs.
Json compare_options_json(const CompareOptions& options, const Comparison& comparison) {
  const DecimateOptions& decimate = comparison.settled.decimate;
  return {{"weld", options.files.weld},
          {"weld_tolerance", to_string(options.files.weld_tolerance)},
          {"effort", word_of(std::span<const Choice<Effort>>(efforts), comparison.effort)},
          {"cost", to_string(decimate.effective_cost())},
          {"polish", *comparison.settled.polish_passes},
          {"flips", *comparison.settled.flips},
          {"samples", options.distance.samples},
          {"seed", options.distance.seed},
          {"threads", options.common.threads}};
}

Json compare_json(const CompareOptions& options, const Scene& input, const Comparison& comparison) {
  Json json = new_report();
  json["input"] = input_json(input, comparison.ours.distance.diagonal);
  json["options"] = compare_options_json(options, comparison);
  json["target"] = target_json(options.targets, comparison.target);
  json["diagonal"] = comparison.ours.distance.diagonal;
  json["whittle"] = contender_json(comparison.ours, "whittle");
  json["whittle"]["seconds"]["polish"] = comparison.ours.polish_seconds;
  json["openmesh"] = contender_json(comparison.stock, "OpenMesh ModQuadric + ModNormalFlipping");
  json["openmesh"]["seconds"]["build"] = comparison.stock_seconds_build;
  json["openmesh"]["lost_faces"] = comparison.stock_lost_faces;
  return json;
}

/// "0.62": ours over theirs; "-" if theirs is 0.
std::string quotient(double ours, double theirs) { return theirs > 0 ? significant(ours / theirs) : "-"; }

/// "--effort normal"
std::string effort_text(const Comparison& comparison) {
  return "--effort " + std::string(word_of(std::span<const Choice<Effort>>(efforts), comparison.effort));
}

/// "--effort normal (--cost memoryless --polish 1)"
std::string what_ran(const Comparison& comparison) {
  const SimplifyOptions& settled = comparison.settled;
  return effort_text(comparison) + " (--cost " + std::string(to_string(settled.decimate.effective_cost())) +
         " --polish " + std::to_string(*settled.polish_passes) + (*settled.flips ? ", edges flipped)" : ")");
}

/// One sentence; empty if our time or OpenMesh's error is 0.
std::string verdict(const Comparison& comparison) {
  const double error = comparison.stock.distance.mean;
  if (!(comparison.ours.seconds() > 0) || !(error > 0)) return {};
  return "whittle " + effort_text(comparison) + ": " +
         significant(comparison.stock.seconds() / comparison.ours.seconds()) + " times as fast, " +
         significant(comparison.ours.distance.mean / error) + " times the mean error\n";
}

/// The rows that say how long both took.
void add_times(Table& table, const Comparison& comparison) {
  const Contender& ours = comparison.ours;
  const Contender& stock = comparison.stock;
  const auto add = [&table](const char* name, double a, double b) {
    table.add({name, seconds_text(a), seconds_text(b), quotient(a, b)});
  };
  add("time to decimate", ours.decimate_seconds, stock.decimate_seconds);
  if (*comparison.settled.polish_passes > 0) {
    table.add({"time to polish", seconds_text(ours.polish_seconds), "-"});
    add("time in all", ours.seconds(), stock.seconds());
  }
  table.add({"time to build its mesh", "-", seconds_text(comparison.stock_seconds_build)});
}

std::string summary_of(const Scene& input, const Comparison& comparison) {
  const Contender& ours = comparison.ours;
  const Contender& stock = comparison.stock;
  const double diagonal = ours.distance.diagonal;
  Table table;
  table.add({"", "whittle", "OpenMesh", "whittle/OpenMesh"});
  const auto add_count = [&table](const char* name, std::size_t a, std::size_t b) {
    table.add({name, std::to_string(a), std::to_string(b)});
  };
  const auto add = [&table](const std::string& name, double a, double b, const std::string& unit = "") {
    table.add({name, significant(a) + unit, significant(b) + unit, quotient(a, b)});
  };
  const auto add_length = [&](const std::string& name, double a, double b) {
    add(name, a, b);
    if (diagonal > 0) add("  of the diagonal", 100 * a / diagonal, 100 * b / diagonal, " %");
  };
  add_count("faces", ours.n_faces, stock.n_faces);
  add_count("vertices", ours.n_vertices, stock.n_vertices);
  add_times(table, comparison);
  add_length("mean error", ours.distance.mean, stock.distance.mean);
  add_length("rms error", ours.distance.rms, stock.distance.rms);
  add_length("largest error", ours.distance.max, stock.distance.max);
  add("Garland-Heckbert 1997", ours.distance.garland_heckbert, stock.distance.garland_heckbert);
  add("faces turned over", ours.distance.flipped_percent, stock.distance.flipped_percent, " %");
  return input.name + ": " + faces_text(input.read.mesh.faces.size()) + ", " +
         vertices_text(input.read.mesh.positions.size()) + "; target: " + to_string(comparison.target) +
         "\nwhittle: " + what_ran(comparison) + "; OpenMesh: ModQuadric and ModNormalFlipping\n\n" + table.text() +
         "\n" + verdict(comparison);
}

void warn_if_missed(const Contender& contender, const std::string& who, const Scene& input,
                    const DecimateTarget& target, const Talk& talk) {
  if (contender.is_met) return;
  talk.warning(input.name + ": " + who + " did not meet the target: " + to_string(target) + " asked, " +
               faces_text(contender.n_faces) + " and " + vertices_text(contender.n_vertices) + " reached");
}

ExitCode run_compare(const Given& /*given*/, CompareOptions options) {
  check_targets(options.targets, "--faces, --vertices, --ratio, --face-ratio and --max-cost");
  check_formats({options.input}, {}, options.files);
  if (options.common.json) check_outputs({{"--json", *options.common.json}}, {options.input}, options.common.force);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  const Input input = read_input(options.input, options.files, options.common.threads, talk);
  const Comparison comparison = compare(input, options, talk);
  warn_if_missed(comparison.ours, "whittle", input, comparison.target, talk);
  warn_if_missed(comparison.stock, "OpenMesh", input, comparison.target, talk);
  if (comparison.stock_lost_faces > 0) {
    talk.warning(input.name + ": OpenMesh's mesh can't hold " + std::to_string(comparison.stock_lost_faces) +
                 " of the " + faces_text(input.read.mesh.faces.size()) +
                 ", so it had less to do, and what it lost counts as its error");
  }
  write_report(
      options.common, [&] { return compare_json(options, input, comparison); }, summary_of(input, comparison));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

OptionRows compare_rows(CompareOptions& options) {
  OptionRows rows{mesh_argument(options.input, options.files)};
  append(rows, target_rows(options.targets, "its unit is length^4 in model units: squared distance times area"));
  rows.push_back({.names = "--effort",
                  .access = choice(options.effort, efforts),
                  .help = effort_meaning,
                  .standard = "normal; fast with --max-cost",
                  .conflicts = conflicts_of_effort()});
  append(rows, sampling_rows(options.distance));
  append(rows, input_rows(options.files));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_compare(CLI::App& app, Command& command) {
  const SubcommandText text{"compare", "Simplify with whittle and with OpenMesh's ModQuadric, side by side.",
                            "IN TARGET... [OPTION]...",
                            "Examples:\n"
                            "  whittle compare dragon.ply --ratio 10%\n"
                            "  whittle compare dragon.ply --faces 5000 --json - | jq '.whittle.mean / .openmesh.mean'"};
  add_subcommand(app, text, CompareOptions{}, compare_rows, run_compare, command);
}

}  // namespace whittle::app
