#include <algorithm>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "commands/measure/attribute_rows.hh"
#include "commands/measure/picture_rows.hh"
#include "commands/measure/posed.hh"
#include "commands/measure/posed_rows.hh"
#include "commands/subcommands.hh"
#include "files/input.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "options/sampling.hh"
#include "pictures/compare_pictures.hh"
#include "terminal/point_text.hh"
#include "terminal/progress_bar.hh"
#include "terminal/table.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"
#include "whittle/metrics/attribute_deviation.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/self_intersections.hh"

namespace whittle::app {
namespace {

struct MeasureOptions {
  std::string reference;
  std::string test;
  FileOptions files;
  metrics::DistanceOptions distance;
  std::optional<double> feature_angle_deg;
  std::optional<double> exact;             ///< accuracy of the largest distance
  std::optional<std::size_t> n_views;      ///< to draw both meshes from
  std::optional<std::string> worst_image;  ///< file for the worst view
  std::optional<std::size_t> n_poses;      ///< to measure both scenes in
  CommonOptions common;
};

/// How the borders, or the feature lines, of both meshes compare.
struct LinesMeasured {
  bool in_reference = false;  ///< whether it has any
  bool in_test = false;
  std::optional<metrics::LineDistance> distance;  ///< set if both have some
};

struct Measurement {
  metrics::SurfaceDistance distance;
  std::vector<metrics::AttributeDeviation> attributes;
  std::optional<metrics::LargestDistances> largest;  ///< set if asked for
  LinesMeasured borders;
  std::optional<LinesMeasured> features;  ///< set if asked for
  metrics::Shape shape;
  metrics::Topology topology;
  std::size_t self_intersections = 0;
  std::optional<PictureErrors> pictures;  ///< set if asked for
  std::optional<PosedDistance> posed;     ///< set if asked for
};

LinesMeasured measure_lines(const std::vector<metrics::Segment>& reference, const std::vector<metrics::Segment>& test,
                            unsigned threads, const ProgressCallback& progress) {
  return {!reference.empty(), !test.empty(),
          metrics::line_distance(reference, test, {.threads = threads, .progress = progress})};
}

Measurement measure(const IndexedMesh& reference, const IndexedMesh& test, const MeasureOptions& options,
                    const Talk& talk) {
  ProgressBar bar(talk, "measuring");
  metrics::DistanceOptions distance = options.distance;
  distance.threads = options.common.threads;
  const double until = options.exact ? 0.4 : 0.7;
  distance.progress = part_of(bar, 0, 0.5 * until);
  const unsigned threads = options.common.threads;
  Measurement measured;
  measured.distance = metrics::surface_distance(reference, test, distance);
  distance.progress = part_of(bar, 0.5 * until, until);
  measured.attributes = metrics::attribute_deviations(reference, test, distance);
  if (options.exact) {
    measured.largest = metrics::largest_distances(reference, test, *options.exact, {threads, part_of(bar, 0.4, 0.7)});
  }
  measured.borders =
      measure_lines(metrics::border_lines(reference), metrics::border_lines(test), threads, part_of(bar, 0.7, 0.75));
  if (const auto angle_deg = options.feature_angle_deg) {
    measured.features = measure_lines(metrics::feature_lines(reference, *angle_deg),
                                      metrics::feature_lines(test, *angle_deg), threads, part_of(bar, 0.75, 0.8));
  }
  measured.shape = metrics::shape(test);
  measured.topology = metrics::topology(test);
  measured.self_intersections = metrics::self_intersections(test, threads, part_of(bar, 0.8, 1)).size();
  return measured;
}

Json features_json(const Measurement& measured, const MeasureOptions& options) {
  if (!measured.features) return nullptr;
  Json json = lines_json(measured.features->distance, measured.distance.diagonal);
  if (!json.is_null()) json["angle_deg"] = *options.feature_angle_deg;
  return json;
}

Json exact_json(const Measurement& measured, const MeasureOptions& options) {
  if (!measured.largest) return nullptr;
  Json json;
  json["accuracy"] = *options.exact;
  json["forward"] = largest_json(measured.largest->forward, measured.distance.diagonal);
  json["backward"] = largest_json(measured.largest->backward, measured.distance.diagonal);
  return json;
}

Json measure_json(const Scene& reference, const Scene& test, const Measurement& measured,
                  const MeasureOptions& options) {
  Json json = new_report();
  json["reference"] = input_json(reference, measured.distance.diagonal);
  json["test"] = input_json(test, diagonal_of(bounds_of(test.read.mesh)));
  json["diagonal"] = measured.distance.diagonal;
  add_distance(json, measured.distance);
  json["attributes"] = attributes_json(measured.attributes);
  json["exact"] = exact_json(measured, options);
  json["border"] = lines_json(measured.borders.distance, measured.distance.diagonal);
  json["features"] = features_json(measured, options);
  add_shape(json, measured.shape);
  json["self_intersections"] = measured.self_intersections;
  add_topology(json, measured.topology);
  json["render"] = measured.pictures ? pictures_json(*measured.pictures) : Json(nullptr);
  json["posed"] = measured.posed ? posed_json(*measured.posed) : Json(nullptr);
  return json;
}

/// Measures both scenes in poses.
PosedDistance measure_posed(const PosedScenes& scenes, const MeasureOptions& options, const Talk& talk) {
  ProgressBar bar(talk, "posing");
  metrics::DistanceOptions distance = options.distance;
  distance.threads = options.common.threads;
  return scenes.measure(*options.n_poses, distance, bar);
}

/// Draws both meshes if asked for.
std::optional<PictureErrors> measure_pictures(const Scene& reference, const Scene& test, const MeasureOptions& options,
                                              const Talk& talk) {
  if (!options.n_views) return std::nullopt;
  ProgressBar bar(talk, "drawing");
  return compare_pictures(reference, test, {*options.n_views, options.common.threads, part_of(bar, 0, 1)});
}

/// Adds the rows for the distance between lines; none if there is no such distance. \param name "borders"
void add_lines(Table& table, const std::string& name, const LinesMeasured& lines, double diagonal) {
  if (!lines.distance) return;
  const metrics::LineDistance& d = *lines.distance;
  const auto length = [diagonal](double x) { return length_text(x, diagonal); };
  table.add({name + ", mean", length(d.mean), length(d.forward.mean), length(d.backward.mean)});
  table.add({name + ", largest", length(d.max), length(d.forward.max), length(d.backward.max)});
}

/// A line that says why there is no distance between lines; empty if there is one. \param name "borders"
std::string lines_missing(const std::string& name, const LinesMeasured& lines) {
  if (lines.distance) return {};
  const char* who = lines.in_reference ? "TEST has none" : lines.in_test ? "REF has none" : "neither mesh has any";
  return "no distance between " + name + ": " + who + '\n';
}

/// Adds two rows that hold the largest distance of all points between them.
void add_largest(Table& table, const metrics::LargestDistances& largest, double diagonal) {
  const auto& [forward, backward] = largest;
  const auto add = [&](const char* name, double there, double back) {
    table.add({name, length_text(std::max(there, back), diagonal), length_text(there, diagonal),
               length_text(back, diagonal)});
  };
  add("of all points, at least", forward.at_least, backward.at_least);
  add("of all points, at most", forward.at_most, backward.at_most);
}

/// "farthest: 1 2 3 in face 7 of TEST"
std::string farthest_line(const metrics::LargestDistances& largest, double diagonal) {
  const bool is_forward = largest.forward.at_least >= largest.backward.at_least;
  const metrics::FarPoint& far = (is_forward ? largest.forward : largest.backward).where;
  return "farthest: " + point_text(far.point, diagonal) + ", in face " + std::to_string(far.face) +
         (is_forward ? " of REF" : " of TEST") + '\n';
}

std::string distance_table(const Measurement& measured) {
  const metrics::SurfaceDistance& d = measured.distance;
  Table table;
  const auto length = [&d](double x) { return length_text(x, d.diagonal); };
  const auto add = [&table](const char* name, const std::string& both, const std::string& there,
                            const std::string& back) {
    table.add({name, both, there, back});
  };
  add("", "both ways", "from REF to TEST", "from TEST to REF");
  add("mean distance", length(d.mean), length(d.forward.mean), length(d.backward.mean));
  add("rms distance", length(d.rms), length(d.forward.rms), length(d.backward.rms));
  add("largest distance", length(d.max), length(d.forward.max), length(d.backward.max));
  if (measured.largest) add_largest(table, *measured.largest, d.diagonal);
  add("normals differ by, deg", significant(d.normal_deviation_deg), significant(d.forward.normal_deviation_deg),
      significant(d.backward.normal_deviation_deg));
  add("faces turned over", significant(d.flipped_percent) + " %", significant(d.forward.flipped_percent) + " %",
      significant(d.backward.flipped_percent) + " %");
  add_lines(table, "borders", measured.borders, d.diagonal);
  if (measured.features) add_lines(table, "feature lines", *measured.features, d.diagonal);
  std::string text =
      table.text() + "Garland-Heckbert 1997, mean squared distance: " + significant(d.garland_heckbert) + '\n';
  if (measured.largest) text += farthest_line(*measured.largest, d.diagonal);
  // If both meshes are closed, missing borders are not worth a line.
  if (measured.borders.in_reference || measured.borders.in_test) text += lines_missing("borders", measured.borders);
  if (measured.features) text += lines_missing("feature lines", *measured.features);
  return text;
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

std::string file_line(const char* role, const Scene& input) {
  return role + input.name + ", " + faces_text(input.read.mesh.faces.size()) + ", " +
         vertices_text(input.read.mesh.positions.size()) + "\n";
}

std::string summary_of(const Scene& reference, const Scene& test, const Measurement& measured) {
  std::string tables = distance_table(measured);
  if (!measured.attributes.empty()) tables += '\n' + attributes_table(measured.attributes);
  if (measured.posed) tables += '\n' + posed_table(*measured.posed);
  if (measured.pictures) tables += '\n' + pictures_table(*measured.pictures);
  return file_line("REF: ", reference) + file_line("TEST: ", test) +
         "lengths in model units, and over the diagonal of REF's box, which is " +
         significant(measured.distance.diagonal) + "\n\n" + tables + "\nTEST\n" + shape_table(measured);
}

/// \throw the errors of `run_measure` before it reads
void check_command(const MeasureOptions& options) {
  check_formats({options.reference, options.test}, {}, options.files);
  std::vector<Output> outputs;
  if (options.common.json) outputs.push_back({"--json", *options.common.json});
  if (options.worst_image) outputs.push_back({"--render-image", *options.worst_image});
  check_outputs(outputs, {options.reference, options.test}, options.common.force);
  if (options.worst_image && !options.n_views) throw UsageError("--render-image needs --render N");
  if (options.n_views) require_pictures();
  if (!options.n_poses) return;
  for (const std::string& path : {options.reference, options.test}) {
    if (!reads_document(path, options.files)) throw UsageError("--posed is for glTF files, which " + path + " is not");
  }
}

ExitCode run_measure(const Given& /*given*/, MeasureOptions options) {
  check_command(options);
  const Talk talk = options.common.talk();
  const Stopwatch watch;
  const auto read = [&](const std::string& path) {
    return read_input(path, options.files, options.common.threads, talk, io::AttributeScope::all);
  };
  const Input reference = read(options.reference);
  const Input test = read(options.test);
  std::optional<PosedScenes> scenes;
  if (options.n_poses) scenes.emplace(reference, test);
  Measurement measured = measure(reference.read.mesh, test.read.mesh, options, talk);
  if (scenes) measured.posed = measure_posed(*scenes, options, talk);
  measured.pictures = measure_pictures(reference, test, options, talk);
  if (measured.pictures) {
    for (const std::string& warning : measured.pictures->warnings) talk.warning(warning);
  }
  OutputFiles files(options.common.force);
  files.protect(reference.needed_files);
  files.protect(test.needed_files);
  if (options.worst_image) {
    files.write(*options.worst_image, [&](std::ostream& out) { out << measured.pictures->worst_png; });
  }
  commit_with_report(
      files, options.common, [&] { return measure_json(reference, test, measured, options); },
      summary_of(reference, test, measured));
  say_effort(talk, watch.seconds());
  return ExitCode::done;
}

OptionRows picture_rows(MeasureOptions& options) {
  constexpr std::uint64_t most = 10'000;
  return {{.names = "--render",
           .access = count(options.n_views, 1, most),
           .help = "also draw both meshes with their textures from N directions, and say how different the pictures "
                   "are: PSNR and FLIP, 1 <= N <= 10000"},
          side_file_row("--render-image", options.worst_image,
                        "write the two pictures with the least PSNR, and their FLIP, as one PNG file"),
          {.names = "--posed",
           .access = count(options.n_poses, 1, most),
           .help = "also measure the scenes of two glTF files in N poses, of their animations or, without these, with "
                   "turned joints and blended morph targets, 1 <= N <= 10000"}};
}

OptionRows measure_rows(MeasureOptions& options) {
  constexpr Range accuracies{1e-6, 1};
  constexpr Range angles{0, 180, false, false};
  OptionRows rows{file_argument("REF", options.reference, "the reference mesh, or '-' for standard input"),
                  file_argument("TEST", options.test, "the mesh to judge, or '-' for standard input")};
  append(rows, sampling_rows(options.distance));
  append(rows, {{.names = "--exact",
                 .access = number(options.exact, accuracies, "A"),
                 .help = "also find the largest distance of all points of both surfaces, not of samples, to a relative "
                         "accuracy of A, " +
                         to_string(accuracies, "A")},
                {.names = "--feature-angle",
                 .access = number(options.feature_angle_deg, angles, "DEG"),
                 .help = "also measure the feature lines, the edges whose two faces turn by more than DEG degrees, " +
                         to_string(angles, "DEG")}});
  append(rows, picture_rows(options));
  append(rows, input_rows(options.files));
  append(rows, common_rows(options.common));
  return rows;
}

}  // namespace

void setup_measure(CLI::App& app, Command& command) {
  const SubcommandText text{"measure", "Say how far TEST is from REF, and how well TEST is made.",
                            "REF TEST [OPTION]...",
                            "Examples:\n"
                            "  whittle measure dragon.ply small.ply\n"
                            "  whittle measure dragon.ply small.ply --json - | jq .mean_rel\n"
                            "  whittle measure fandisk.off small.off --feature-angle 40\n"
                            "  whittle measure fandisk.off small.off --exact 1e-3\n"
                            "  whittle measure helmet.glb small.glb --render 24 --render-image worst.png\n"
                            "  whittle measure knight.glb small.glb --posed 16"};
  MeasureOptions defaults;
  defaults.files.reads_documents = true;
  defaults.files.scope = SceneScope::scene;
  add_subcommand(app, text, defaults, measure_rows, run_measure, command);
}

}  // namespace whittle::app
