#include "commands/page/make_page.hh"

#include <array>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

#include "commands/page/page_charts.hh"
#include "commands/page/page_look.hh"
#include "commands/page/page_tables.hh"
#include "commands/page/run/run_report.hh"
#include "commands/recording/curve.hh"
#include "commands/recording/recording_input.hh"
#include "terminal/progress_bar.hh"
#include "terminal/table.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/progress.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/errors.hh"
#include "whittle/io/path_of.hh"
#include "whittle/progressive/recording.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::app {
namespace {

bool is_recording(const std::string& path) {
  std::array<char, 8> begin{};
  std::ifstream file(io::path_of(path), std::ios::binary);
  file.read(begin.data(), begin.size());
  return file && std::string_view(begin.data(), begin.size()) == progressive::recording_signature;
}

/// The mean one; of a mesh without lengths, so long that nothing depends on it.
double edge_length(const metrics::Shape& shape) {
  return shape.edge_length_mean > 0 ? shape.edge_length_mean : std::numeric_limits<double>::infinity();
}

class PageMaker {
 public:
  PageMaker(const ReportCommand& options, const Talk& talk, PageFacts& facts)
      : options_(options), talk_(talk), facts_(facts) {}

  std::string make();
  std::string make_of(const RunForPage& run);
  /// What was made a page of. Afterwards nothing is left.
  ShownMeshes take_shown();

 private:
  unsigned threads() const { return options_.common.threads; }
  void warn(const std::string& warning) {
    talk_.warning(warning);
    facts_.warnings.push_back(warning);
  }
  Input read(const std::string& path);
  PageLook look_of(const Scene& input);
  static report::PageSurface surface_of(std::string name, IndexedMesh mesh, const PageLook& look);
  void read_files();
  void take(const RunForPage& run);
  std::string compose();
  void use_recording(const std::string& path);
  void add_result(const std::string& path, report::PageSurface surface);
  void measure_distances();
  void measure_attributes();
  void measure_recording();
  void measure_file(const report::PageSurface& surface, const std::string& path);
  void add_tables();
  void add_run(const Json& run);
  void add_charts();
  void limit_size(report::PageSurface& surface);
  void fill_facts(std::size_t i, const report::PageSurface& surface);

  const ReportCommand& options_;
  const Talk& talk_;
  PageFacts& facts_;
  std::vector<std::string> paths_;  ///< of the meshes, the original's first
  report::Page page_;
  std::vector<CurvePoint> curve_;
  std::vector<MeasuredMesh> measured_;  ///< the files, the original first
  Json figures_ = Json::object();       ///< of the files and the run, for the page
  double diagonal_ = 0;
};

Input PageMaker::read(const std::string& path) {
  Input input = read_input(path, options_.files_options, threads(), talk_, io::AttributeScope::all);
  for (const std::string& warning : input.warnings) facts_.warnings.push_back(warning);
  return input;
}

PageLook PageMaker::look_of(const Scene& input) {
  std::vector<std::string> warnings;
  PageLook look(input, warnings);
  for (const std::string& warning : warnings) warn(warning);
  return look;
}

report::PageSurface PageMaker::surface_of(std::string name, IndexedMesh mesh, const PageLook& look) {
  report::PageSurface surface{std::move(name), std::move(mesh), {}, {}, {}, std::nullopt};
  look.dress(surface);
  return surface;
}

void PageMaker::add_result(const std::string& path, report::PageSurface surface) {
  if (surface.mesh.faces.empty()) {
    warn(path + ": has no faces, and is left out");
    return;
  }
  paths_.push_back(path);
  page_.results.push_back(std::move(surface));
}

/// \pre it comes first, or after the original
void PageMaker::use_recording(const std::string& path) {
  if (page_.recording) throw UsageError("two recordings: " + path + " is one too many");
  RecordingInput input{path, std::nullopt, "give the mesh before it, as in 'whittle report MESH " + path + " -o PAGE'"};
  const bool is_first = path == options_.files.front();
  if (!is_first) input.input = options_.files.front();
  RecordingFacts facts;
  page_.recording.emplace(
      report::PageRecording{read_replay(input, options_.files_options, threads(), talk_, facts), {}, {}});
  facts_.recording = recording_json(facts);
  progressive::Replay& replay = page_.recording->replay;
  if (is_first) {
    paths_.push_back(path);
    page_.original = surface_of(short_name(path) + ", its first level", replay.input(), PageLook());
  }
  replay.go_to(replay.n_steps());
  add_result(path, surface_of(short_name(path) + ", its last level", replay.decimation().mesh, PageLook()));
}

void PageMaker::read_files() {
  const Stopwatch watch;
  for (const std::string& path : options_.files) {
    if (is_recording(path)) {
      use_recording(path);
      continue;
    }
    Input input = read(path);
    const PageLook look = look_of(input);
    report::PageSurface surface = surface_of(short_name(path), std::move(input.read.mesh), look);
    if (paths_.empty()) {
      paths_.push_back(path);
      page_.original = std::move(surface);
    } else {
      add_result(path, std::move(surface));
    }
  }
  report::PageOrder order = report::put_in_page_order(page_.original.mesh);
  if (page_.recording) page_.recording->order = std::move(order);
  for (report::PageSurface& result : page_.results) report::put_in_page_order(result.mesh);
  diagonal_ = diagonal_of(bounds_of(page_.original.mesh));
  facts_.read_seconds = watch.seconds();
}

/// A coarser level in place of a mesh that is too large for the page.
void PageMaker::limit_size(report::PageSurface& surface) {
  const std::size_t n = surface.mesh.faces.size();
  if (n <= options_.most_faces) return;
  if (&surface == &page_.original && page_.recording) {
    page_.recording.reset();
    facts_.recording = nullptr;
    warn(surface.name + " has more faces than --max-faces: the page can't play the recording");
  }
  SimplifyOptions simplify;
  simplify.decimate.threads = threads();
  Simplification coarser =
      whittle::simplify(surface.mesh, DecimateTarget::faces(options_.most_faces), Effort::fast, simplify);
  surface.mesh = std::move(coarser.mesh);
  report::put_in_page_order(surface.mesh);
  surface.refusals.clear();  // their vertices may be gone
  surface.note = "A coarser level is shown: the file has " + faces_text(n);
  surface.n_faces_of_file = n;
}

void PageMaker::fill_facts(std::size_t i, const report::PageSurface& surface) {
  facts_.meshes[i]["shown_faces"] = surface.mesh.faces.size();
  facts_.meshes[i]["colour_deviation"] = surface.distances ? Json(surface.distances->deviation) : Json(nullptr);
  facts_.meshes[i]["max_distance"] = surface.distances ? Json(surface.distances->max) : Json(nullptr);
}

/// From what is shown to the files, also where a coarser level is shown.
void PageMaker::measure_distances() {
  const Stopwatch watch;
  ProgressBar bar(talk_, "measuring");
  if (page_.results.empty()) {
    limit_size(page_.original);
  } else {
    const TriangleTree of_original(page_.original.mesh);
    const TriangleTree of_first(page_.results.front().mesh);
    const auto map = [this](const IndexedMesh& mesh, const TriangleTree& other, double edge) {
      constexpr std::size_t least = 110'000;
      return report::distance_map(mesh, other,
                                  {.spacing = edge,
                                   .most_faces = std::max(least, page_.original.mesh.faces.size() / 2 * 3),
                                   .threads = threads()});
    };
    for (report::PageSurface& result : page_.results) {
      limit_size(result);
      result.distances = map(result.mesh, of_original, edge_length(measured_[0].shape));
    }
    limit_size(page_.original);
    page_.original.distances = map(page_.original.mesh, of_first, edge_length(measured_[1].shape));
  }
  page_.original.coarse = report::coarse_faces(page_.original.mesh, threads());
  for (report::PageSurface& result : page_.results) result.coarse = report::coarse_faces(result.mesh, threads());
  fill_facts(0, page_.original);
  for (std::size_t i = 0; i < page_.results.size(); ++i) fill_facts(i + 1, page_.results[i]);
  facts_.measure_seconds = watch.seconds();
}

/// As distances: from what is shown, to what is shown of the other file.
void PageMaker::measure_attributes() {
  const Stopwatch watch;
  for (report::PageSurface& result : page_.results) {
    result.attribute_maps = report::attribute_maps(result.mesh, page_.original.mesh, threads());
  }
  if (!page_.results.empty()) {
    page_.original.attribute_maps = report::attribute_maps(page_.original.mesh, page_.results.front().mesh, threads());
  }
  facts_.measure_seconds += watch.seconds();
}

void PageMaker::measure_recording() {
  if (!page_.recording) return;
  constexpr std::size_t samples = 20'000;
  curve_ = measure_curve(page_.recording->replay, samples, threads(), talk_);
  for (const CurvePoint& point : curve_) page_.recording->levels.push_back({point.n_faces, point.mean, point.max});
}

/// The original first.
void PageMaker::measure_file(const report::PageSurface& surface, const std::string& path) {
  MeasuredMesh measured{surface.name, metrics::topology(surface.mesh), metrics::shape(surface.mesh), std::nullopt};
  Json json{{"path", path}, {"vertices", measured.topology.vertices}, {"faces", measured.topology.faces}};
  if (measured_.empty()) {
    json["diagonal"] = diagonal_;
  } else {
    metrics::DistanceOptions how;
    how.samples = 100'000;
    how.threads = threads();
    measured.distance = metrics::surface_distance(page_.original.mesh, surface.mesh, how);
    add_distance(json["distance"], *measured.distance);
  }
  add_topology(json, measured.topology);
  add_shape(json, measured.shape);
  figures_["meshes"].push_back(std::move(json));
  facts_.meshes.push_back(
      {{"path", path}, {"vertices", surface.mesh.positions.size()}, {"faces", surface.mesh.faces.size()}});
  measured_.push_back(std::move(measured));
}

/// Of the files, so before coarser levels are made.
void PageMaker::add_tables() {
  measure_file(page_.original, paths_[0]);
  for (std::size_t i = 0; i < page_.results.size(); ++i) {
    report::PageSurface& result = page_.results[i];
    measure_file(result, paths_[i + 1]);
    result.error = {measured_.back().distance->mean, measured_.back().distance->max};
  }
  page_.tables.push_back(mesh_table(measured_));
}

/// \pre the meshes are in `facts_`
void PageMaker::add_run(const Json& run) {
  std::vector<std::optional<std::uint64_t>> faces;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    // A scene may show a mesh several times, and a run of glTF counts it once.
    const bool is_scene = reads_document(paths_[i], options_.files_options);
    faces.push_back(is_scene ? std::nullopt : std::optional(facts_.meshes[i]["faces"].get<std::uint64_t>()));
  }
  if (const std::string doubt = doubt_about_run(run, faces); !doubt.empty()) warn(about(*options_.run, doubt));
  page_.tables.push_back(run_table("The run: " + short_name(*options_.run), run_of(run, faces)));
  figures_["run"] = run;
}

void PageMaker::add_charts() {
  std::vector<PageMesh> meshes;
  const auto add = [&](const report::PageSurface& surface) {
    meshes.push_back({surface.name, measured_[meshes.size()].shape, surface.distances ? &*surface.distances : nullptr});
  };
  add(page_.original);
  for (const report::PageSurface& result : page_.results) add(result);
  page_.charts = page_charts(meshes, curve_);
}

/// The refused pairs of each reason, by the numbers that the page gives vertices.
std::vector<report::PageRefusals> refusals_of(const Simplification& simplified, const report::PageOrder& order) {
  std::vector<report::PageRefusals> refusals;
  for (const RefusalRow& row : all_refusals) {
    report::PageRefusals one{std::string(row.words), {}};
    for (const auto& [pair, reason] : simplified.refused_pairs) {
      if (reason == row.refusal) one.pairs.push_back({order.of_vertex[pair.a], order.of_vertex[pair.b]});
    }
    if (!one.pairs.empty()) refusals.push_back(std::move(one));
  }
  return refusals;
}

void PageMaker::take(const RunForPage& run) {
  const std::string name = short_name(run.input.name);
  const PageLook look = look_of(run.input);
  paths_ = {run.input.name};
  page_.title = name + ", " + short_name(run.output);
  page_.advice = run.advice;
  page_.original = surface_of(name, run.input.read.mesh, look);
  page_.recording.emplace(report::PageRecording{
      progressive::Replay(without_attributes(page_.original.mesh), run.simplified.steps, Normals::drop), {}, {}});
  page_.recording->order = report::put_in_page_order(page_.original.mesh);
  add_result(run.output, surface_of(short_name(run.output), run.simplified.mesh, look));
  if (!page_.results.empty()) {
    report::PageSurface& result = page_.results.front();
    result.refusals = refusals_of(run.simplified, report::put_in_page_order(result.mesh));
  }
  diagonal_ = diagonal_of(bounds_of(page_.original.mesh));
}

std::string PageMaker::make() {
  const Json run = options_.run ? read_report_of_simplify(*options_.run) : Json();
  read_files();
  for (const std::string& path : options_.files) page_.title += (page_.title.empty() ? "" : ", ") + short_name(path);
  add_tables();
  if (options_.run) add_run(run);
  return compose();
}

std::string PageMaker::make_of(const RunForPage& run) {
  take(run);
  add_tables();
  page_.tables.push_back(run_table("The run", run.report));
  figures_["run"] = run.report;
  return compose();
}

ShownSurface shown_surface(report::PageSurface surface) {
  ShownSurface shown{std::move(surface.name),
                     std::move(surface.note),
                     std::move(surface.mesh),
                     std::move(surface.materials),
                     surface.colors,
                     std::nullopt,
                     {}};
  if (surface.distances) {
    shown.distances = {std::move(surface.distances->mesh), std::move(surface.distances->signed_distances),
                       surface.distances->max, surface.distances->usual};
  }
  for (report::AttributeMap& map : surface.attribute_maps) {
    shown.deviations.push_back({map.kind, std::move(map.deviations), map.max, map.usual});
  }
  return shown;
}

ShownMeshes PageMaker::take_shown() {
  ShownMeshes shown{shown_surface(std::move(page_.original)), {}, std::nullopt};
  for (report::PageSurface& result : page_.results) shown.results.push_back(shown_surface(std::move(result)));
  if (page_.recording) shown.run = std::move(page_.recording->replay);
  return shown;
}

std::string PageMaker::compose() {
  measure_recording();
  measure_distances();
  measure_attributes();
  add_charts();
  page_.json = to_text(figures_);
  std::ostringstream out;
  write_page(out, page_);
  return std::move(out).str();
}

}  // namespace

bool has_page() { return true; }

std::string make_page(const RunForPage& run, const CommonOptions& common, const Talk& talk) {
  ReportCommand options;
  options.common = common;
  PageFacts facts;
  return PageMaker(options, talk, facts).make_of(run);
}

MadePage make_page(const ReportCommand& options, const Talk& talk, PageFacts& facts) {
  PageMaker maker(options, talk, facts);
  std::string html = maker.make();
  return {std::move(html), maker.take_shown()};
}

}  // namespace whittle::app
