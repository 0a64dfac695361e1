#include "page/session.hh"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/path_of.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/pipeline/simplify_file.hh"
#include "whittle/scene/materials.hh"
#include "whittle/scene/read_scene.hh"
#include "whittle/scene/write_scene.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::web {
namespace {

constexpr char output_folder[] = "out/";

SceneReadOptions reading_for(const SceneFormat* output) {
  SceneReadOptions reading;
  reading.threads = 1;
  reading.scope = scope_for(output);
  reading.takes_no_triangles = reading.scope == SceneScope::meshes;
  return reading;
}

SimplifyOptions quick_options(const RunObserver& observer) {
  SimplifyOptions options;
  options.decimate.threads = 1;
  options.decimate.progress = [&observer](const Progress& progress) { return observer(run_progress(progress)); };
  return options;
}

metrics::SurfaceDistance distance_of(metrics::DistanceReference& original, const IndexedMesh& mesh, std::size_t samples,
                                     const RunObserver& observer) {
  metrics::DistanceOptions how;
  how.samples = samples;
  how.threads = 1;
  how.progress = [&observer](const TaskProgress& progress) {
    return observer({.stage = "measuring", .fraction = progress.fraction});
  };
  return original.to(mesh, how);
}

/// "dragon", of "dragon.ply" and of "dragon.ply.gz"
std::string stem_of(const std::string& path) {
  const std::string name = io::path_of(path).filename().string();
  return name.substr(0, name.find('.', 1));
}

/// Files that the scene names and nobody gave. Without them it is drawn without materials.
std::vector<std::string> missing_files(const Scene& scene) {
  std::vector<std::string> missing;
  for (const std::filesystem::path& file : scene.needed_files) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) missing.push_back(file.string());
  }
  return missing;
}

void throw_unless_faces(const Scene& scene) {
  if (scene.read.mesh.faces.empty()) throw io::ReadError(scene.name, why_no_faces(scene.read));
}

}  // namespace

Session::Session(const std::string& path, RunObserver observer)
    : path_(path), observer_(std::move(observer)), original_(scene_.read.mesh) {
  observer_({.stage = "reading"});
  scene_ = read_scene(path_, reading_for(format_by_name(path_)));
  throw_unless_faces(scene_);
  diagonal_ = diagonal_of(bounds_of(scene_.read.mesh));
  page_.title = scene_.name;
}

Json Session::facts() const {
  const IndexedMesh& mesh = scene_.read.mesh;
  std::vector<std::string> warnings = scene_.warnings;
  for (const std::string& file : missing_files(scene_)) {
    warnings.push_back(file + " is not among the files: the mesh is drawn without its materials");
  }
  Json formats = Json::array();
  for (const SceneFormat* const format : scene_formats()) {
    formats.push_back({{"id", format->extensions.front()}, {"name", format->title}});
  }
  return {{"name", scene_.name},
          {"vertices", mesh.positions.size()},
          {"faces", mesh.faces.size()},
          {"diagonal", diagonal_},
          {"warnings", std::move(warnings)},
          {"format", scene_.format->extensions.front()},
          {"formats", std::move(formats)}};
}

/// With its materials. Of a mesh that is too large to draw, a coarser level.
report::PageSurface Session::surface_of(std::string name, const IndexedMesh& mesh) const {
  report::PageSurface surface{std::move(name), {}, {}, {}, {}, std::nullopt};
  if (const std::size_t n = mesh.faces.size(); n > most_shown) {
    const DecimateTarget target = DecimateTarget::faces(most_shown);
    surface.mesh = whittle::simplify(mesh, target, Effort::fast, quick_options(observer_)).mesh;
    surface.note = "A coarser level is shown";
    surface.n_faces_of_file = n;
  } else {
    surface.mesh = mesh;
  }
  if (!missing_files(scene_).empty()) return surface;
  SceneMaterials materials = read_materials(scene_);
  if (materials.are_told) surface.materials = std::move(materials.of_groups);
  surface.colors = materials.colors;
  return surface;
}

void Session::record() {
  page_.original = surface_of(scene_.name, scene_.read.mesh);
  constexpr std::size_t least = 12;
  const std::size_t n = page_.original.mesh.faces.size();
  SimplifyOptions options = quick_options(observer_);
  options.decimate.keep_steps = true;
  const Simplification run =
      whittle::simplify(page_.original.mesh, DecimateTarget::faces(std::max(least, n / 1000)), Effort::fast, options);
  page_.recording.emplace(report::PageRecording{
      progressive::Replay(without_attributes(page_.original.mesh), run.steps, Normals::drop), {}, {}});
  page_.recording->order = report::put_in_page_order(page_.original.mesh);
  page_.original.coarse = report::coarse_faces(page_.original.mesh, 1);
  list_levels();
}

void Session::list_levels() {
  const std::vector<std::size_t> levels = progressive::levels_of_curve(page_.recording->replay);
  levels_to_measure_.clear();
  for (std::size_t i = 0; i < levels.size(); i += 2) levels_to_measure_.push_back(levels[i]);
  for (std::size_t i = 1; i < levels.size(); i += 2) levels_to_measure_.push_back(levels[i]);
  std::reverse(levels_to_measure_.begin(), levels_to_measure_.end());
}

Json Session::measure_next_level() {
  if (levels_to_measure_.empty()) return nullptr;
  progressive::Replay& replay = page_.recording->replay;
  replay.go_to(levels_to_measure_.back());
  levels_to_measure_.pop_back();
  report::PageLevel level{replay.n_faces(), 0, 0};
  const bool is_original = replay.level() == 0 && page_.original.n_faces_of_file == 0;
  if (!is_original && level.n_faces > 0) {
    constexpr std::size_t samples = 20'000;
    const auto distance = distance_of(original_, replay.decimation().mesh, samples, observer_);
    level.mean_error = distance.mean;
    level.max_error = distance.max;
  }
  std::vector<report::PageLevel>& levels = page_.recording->levels;
  const auto after = std::find_if(levels.begin(), levels.end(),
                                  [&](const report::PageLevel& other) { return other.n_faces < level.n_faces; });
  levels.insert(after, level);
  return {{"faces", level.n_faces}, {"mean", level.mean_error}, {"max", level.max_error}};
}

SceneOutput Session::output_of(const SceneFormat& format) const {
  SceneOutput output;
  output.path = output_folder + stem_of(path_) + "." + std::string(format.extensions.front());
  output.format = &format;
  return output;
}

void Session::run(const SceneFormat& format) {
  done_.reset();
  original_ = metrics::DistanceReference(scene_.read.mesh);  // memory for the run
  request_.output = output_of(format);
  request_.reading = reading_for(&format);
  observer_({.stage = "reading"});
  Plan plan = whittle::plan(read_scene(path_, request_.reading), request_);
  Outcome outcome = whittle::run(plan, observer_);
  done_.emplace(Done{std::move(plan), std::move(outcome)});
}

void Session::show_result() {
  const IndexedMesh& mesh = done_->outcome.simplified.mesh;
  page_.results.clear();
  if (mesh.faces.empty()) return;
  report::PageSurface& result = page_.results.emplace_back(surface_of("result", mesh));
  report::put_in_page_order(result.mesh);
  result.coarse = report::coarse_faces(result.mesh, 1);
}

Json Session::simplify(std::optional<std::uint64_t> n_faces, std::optional<double> max_error, Effort effort) {
  request_ = {};
  request_.targets.faces = n_faces;
  if (max_error) request_.targets.max_error = Length{*max_error, false};
  request_.effort = effort;
  const Stopwatch watch;
  run(*scene_.format);
  const double seconds = watch.seconds();
  const auto& [plan, outcome] = *done_;
  const IndexedMesh& mesh = outcome.simplified.mesh;
  show_result();
  std::vector<std::string> texts = all_warnings(plan, outcome);
  if (!outcome.met) texts.push_back(shortfall_text(plan, outcome));
  const std::optional<double> proven = outcome.simplified.result.proven_error;
  return {{"vertices", mesh.positions.size()},
          {"faces", mesh.faces.size()},
          {"met", outcome.met},
          {"texts", std::move(texts)},
          {"proven", proven ? Json(*proven) : Json(nullptr)},
          {"seconds", seconds}};
}

Json Session::measure_result() {
  throw_unless_done();
  if (page_.results.empty()) return nullptr;
  constexpr std::size_t samples = 100'000;
  const auto distance = distance_of(original_, done_->outcome.simplified.mesh, samples, observer_);
  page_.results.front().error = {distance.mean, distance.max};
  return {{"mean", distance.mean}, {"max", distance.max}};
}

void Session::throw_unless_done() const {
  if (!done_) throw std::invalid_argument("there is no result yet");
}

std::vector<std::string> Session::write(const std::string& name) {
  throw_unless_done();
  const SceneFormat* const format = format_by_extension(name);
  if (format == nullptr) throw std::invalid_argument("'" + name + "' is no format that is written");
  // A proof is about the file.
  const bool is_other_run =
      scope_for(format) != request_.reading.scope || (request_.targets.max_error && format != request_.output.format);
  if (is_other_run) run(*format);
  io::OutputFiles files;
  SceneMessages messages;
  write_scene(files, output_of(*format), done_->plan.scene, done_->outcome.simplified.mesh, messages);
  files.commit();
  for (std::string& line : messages.warnings) {
    if (line.starts_with(output_folder)) line.erase(0, std::size(output_folder) - 1);
  }
  return std::move(messages.warnings);
}

}  // namespace whittle::web
