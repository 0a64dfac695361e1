#include <memory>
#include <string>
#include <vector>

#include "input.hh"
#include "output.hh"
#include "report.hh"
#include "sampling.hh"
#include "stopwatch.hh"
#include "subcommands.hh"
#include "table.hh"
#include "whittle/metrics/self_intersections.hh"

namespace whittle::app {
namespace {

struct MeasureOptions {
  std::string reference;
  std::string test;
  InputOptions reading;
  metrics::DistanceOptions distance;
  CommonOptions common;
};

struct Measurement {
  metrics::SurfaceDistance distance;
  metrics::Shape shape;
  metrics::Topology topology;
  std::size_t self_intersections = 0;
};

Measurement measure(const IndexedMesh& reference, const IndexedMesh& test, const MeasureOptions& options) {
  metrics::DistanceOptions distance = options.distance;
  distance.threads = options.common.threads;
  return {metrics::surface_distance(reference, test, distance), metrics::shape(test), metrics::topology(test),
          metrics::self_intersections(test, options.common.threads).size()};
}

Json measure_json(const Input& reference, const Input& test, const Measurement& measured) {
  Json json = new_report();
  json["reference"] = input_json(reference, measured.distance.diagonal);
  json["test"] = input_json(test, metrics::bounds(test.read.mesh).diagonal());
  json["diagonal"] = measured.distance.diagonal;
  add_distance(json, measured.distance);
  add_shape(json, measured.shape);
  json["self_intersections"] = measured.self_intersections;
  add_topology(json, measured.topology);
  return json;
}

std::string distance_table(const metrics::SurfaceDistance& d) {
  Table table;
  const auto length = [&d](double x) { return significant(x) + " (" + percent(x / d.diagonal) + ")"; };
  const auto add = [&table](const char* name, const std::string& both, const std::string& there,
                            const std::string& back) {
    table.add({name, both, there, back});
  };
  add("", "both ways", "from REF to TEST", "from TEST to REF");
  add("mean distance", length(d.mean), length(d.forward.mean), length(d.backward.mean));
  add("rms distance", length(d.rms), length(d.forward.rms), length(d.backward.rms));
  add("largest distance", length(d.max), length(d.forward.max), length(d.backward.max));
  add("normals differ by, deg", significant(d.normal_deviation_deg), significant(d.forward.normal_deviation_deg),
      significant(d.backward.normal_deviation_deg));
  add("faces turned over", significant(d.flipped_percent) + " %", significant(d.forward.flipped_percent) + " %",
      significant(d.backward.flipped_percent) + " %");
  return table.text() + "Garland-Heckbert 1997, mean squared distance: " + significant(d.garland_heckbert) + '\n';
}

std::string shape_table(const Measurement& measured) {
  const metrics::Shape& shape = measured.shape;
  const metrics::Topology& topology = measured.topology;
  Table table;
  const auto add = [&table](const char* name, const std::string& value) { table.add({name, value}); };
  add("radius ratio, mean / least", significant(shape.radius_ratio_mean) + " / " + significant(shape.radius_ratio_min));
  add("least angle, mean / least, deg",
      significant(shape.min_angle_mean_deg) + " / " + significant(shape.min_angle_min_deg));
  add("valence 5 to 7", percent(shape.valence.share_5_to_7));
  add("valence, least / greatest", std::to_string(shape.valence.min) + " / " + std::to_string(shape.valence.max));
  add("edge lengths, deviation / mean", significant(shape.edge_length_cv));
  add("folds", std::to_string(shape.folds));
  add("self-intersections", std::to_string(measured.self_intersections));
  add("degenerate faces", std::to_string(shape.degenerate_faces));
  add("manifold / closed", yes_no(topology.manifold) + " / " + yes_no(topology.closed));
  add("components", std::to_string(topology.components));
  return table.text();
}

std::string file_line(const char* role, const Input& input) {
  return role + input.name + ", " + std::to_string(input.read.mesh.faces.size()) + " faces, " +
         std::to_string(input.read.mesh.positions.size()) + " vertices\n";
}

std::string to_text(const Input& reference, const Input& test, const Measurement& measured) {
  return file_line("REF: ", reference) + file_line("TEST: ", test) +
         "lengths in model units, and over the diagonal of REF's box, which is " +
         significant(measured.distance.diagonal) + "\n\n" + distance_table(measured.distance) + "\nTEST\n" +
         shape_table(measured);
}

ExitCode run_measure(const CLI::App& app, const MeasureOptions& options) {
  check_conflicts(app, common_conflicts());
  check_inputs({options.reference, options.test}, {}, options.reading.format);
  if (options.common.json) {
    check_outputs({{"--json", *options.common.json}}, {options.reference, options.test}, options.common.force);
  }
  const Talk talk(options.common.volume());
  const Stopwatch watch;
  const Input reference = read_input(options.reference, options.reading, talk);
  const Input test = read_input(options.test, options.reading, talk);
  const Measurement measured = measure(reference.read.mesh, test.read.mesh, options);
  write_report(options.common, measure_json(reference, test, measured), to_text(reference, test, measured));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

}  // namespace

void setup_measure(CLI::App& app, Command& command) {
  const auto options = std::make_shared<MeasureOptions>();
  CLI::App* sub = app.add_subcommand("measure", "Say how far TEST is from REF, and how well TEST is made.");
  add_file(*sub, "REF", options->reference, "the reference mesh, or '-' for standard input");
  add_file(*sub, "TEST", options->test, "the mesh to judge, or '-' for standard input");
  add_sampling_options(*sub, options->distance);
  add_format(*sub, options->reading);
  add_no_weld(*sub, options->reading);
  add_common_options(*sub, options->common);
  set_usage(*sub, "REF TEST [OPTION]...");
  sub->footer(
      "Examples:\n"
      "  whittle measure dragon.ply small.ply\n"
      "  whittle measure dragon.ply small.ply --json - | jq .mean_rel");
  sub->callback([sub, options, &command] { command = [sub, options] { return run_measure(*sub, *options); }; });
}

}  // namespace whittle::app
