#include "whittle/pipeline/levels.hh"

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "run/proof.hh"
#include "whittle/core/detail/portable_math.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/progress.hh"
#include "whittle/core/text/text.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/pipeline/new_intersections.hh"
#include "whittle/pipeline/run.hh"
#include "whittle/pipeline/values.hh"
#include "whittle/progressive/levels.hh"
#include "whittle/scene/read_scene.hh"
#include "whittle/scene/write_scene.hh"

namespace whittle {
namespace {

/// \throw std::invalid_argument
void check(const LevelTargets& targets) {
  if (targets.n_kinds() != 1) throw std::invalid_argument("levels need targets of one kind");
  for (const std::vector<double>* shares : {&targets.ratios, &targets.face_ratios}) {
    for (const double ratio : *shares) {
      if (!(ratio > 0 && ratio < 1)) throw std::invalid_argument("the share of a level is not between 0 and 1");
    }
  }
  if (std::count(targets.faces.begin(), targets.faces.end(), 0) > 0) {
    throw std::invalid_argument("a level has no faces");
  }
  for (const Length& error : targets.errors) {
    if (!(error.value > 0)) throw std::invalid_argument("the error of a level is not above 0");
  }
  for (const Length& distance : targets.distances) {
    if (!(distance.value > 0)) throw std::invalid_argument("the distance of a level is not above 0");
  }
  const CameraView& view = targets.view;
  if (!(view.target_pixels > 0 && view.height > 0 && view.fov_deg > 0 && view.fov_deg < 180)) {
    throw std::invalid_argument(
        "a view needs pixels, a height and a field of view above 0, and that below 180 degrees");
  }
}

/// Counts in descending order, each once.
std::vector<DecimateTarget> counts_of(const LevelTargets& targets, const Scene& scene) {
  const IndexedMesh& mesh = scene.read.mesh;
  std::vector<std::uint64_t> counts = targets.faces;
  for (const double ratio : targets.ratios) counts.push_back(share_of(ratio, mesh.positions.size()));
  for (const double ratio : targets.face_ratios) counts.push_back(share_of(ratio, mesh.faces.size()));
  std::sort(counts.begin(), counts.end(), std::greater<>());
  counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
  if (!targets.faces.empty() && counts.front() >= mesh.faces.size()) {
    throw std::invalid_argument(scene.name + " has " + faces_text(mesh.faces.size()) + ", and " +
                                std::to_string(counts.front()) + " are asked");
  }
  std::vector<DecimateTarget> result;
  result.reserve(counts.size());
  for (const std::uint64_t n : counts) {
    result.push_back(targets.ratios.empty() ? DecimateTarget::faces(n) : DecimateTarget::vertices(n));
  }
  return result;
}

/// A limit of a level's error, model units.
struct Limit {
  double error;
  std::optional<double> distance;  ///< of the camera, from which it follows
};

/// Limits by error, ascending, each once.
std::vector<Limit> limits_of(const LevelTargets& targets, const Scene& scene) {
  const double diagonal = diagonal_of(bounds_of(scene.read.mesh));
  std::vector<Limit> limits;
  for (const Length& error : targets.errors) limits.push_back({error.in_units(diagonal), std::nullopt});
  for (const Length& length : targets.distances) {
    const double distance = length.in_units(diagonal);
    limits.push_back({distance * targets.view.error_over_distance(), distance});
  }
  std::sort(limits.begin(), limits.end(), [](const Limit& a, const Limit& b) { return a.error < b.error; });
  const auto is_same = [](const Limit& a, const Limit& b) { return a.error == b.error; };
  limits.erase(std::unique(limits.begin(), limits.end(), is_same), limits.end());
  return limits;
}

/// A run that can't go on leaves levels out.
void warn_of_missing_levels(const Scene& scene, std::size_t n_asked, Levels& levels) {
  const Decimation& last = levels.levels.back().simplified;
  const bool is_last_met = last.result.stop == StopReason::target;
  if (levels.levels.size() == n_asked && is_last_met) return;
  const std::size_t n_met = levels.levels.size() - (is_last_met ? 0 : 1);
  const std::string reasons = reasons_at_end(last.result.refused_at_end);
  levels.warnings.push_back(about(
      scene.name, counted(n_asked - n_met, "level", "levels") + " not reached: the last one has " +
                      faces_text(last.mesh.faces.size()) + ", and " +
                      (reasons.empty() ? "nothing is left that may be contracted" : "the pairs left are " + reasons)));
}

void warn_of_new_intersections(const Scene& scene, unsigned threads, Levels& levels) {
  for (const Level& level : levels.levels) {
    const NewIntersections found = find_new_intersections(scene.read.mesh, level.simplified, threads);
    for (const std::string& text : {found.of_parts, found.of_walls}) {
      if (text.empty()) continue;
      levels.warnings.push_back(scene.name + ": at " + std::to_string(level.simplified.mesh.faces.size()) + " faces, " +
                                text);
    }
  }
}

/// Proves levels as they are written: of a document that compression rounds, the scene as it is shown.
class LevelsProof {
 public:
  LevelsProof(const Scene& scene, const SceneOutput& output, const SceneReadOptions& reading)
      : scene_(scene), output_(output), reading_(reading), stretch_(widest_stretch(scene)) {
    if (output.gltf.rounds() && keeps_meshes(scene, output)) shown_ = shown_scene(scene, reading);
  }

  bool is_within(const Decimation& level, double distance) const {
    const IndexedMesh written = output_.gltf.rounds() ? scene_as_written(output_, scene_, level.mesh, reading_)
                                                      : as_written(output_, scene_, level.mesh, reading_);
    if (written.faces.empty()) return false;
    metrics::CertifyOptions options{.threads = reading_.threads};
    if (!output_.gltf.rounds() && written.positions.size() == level.mesh.positions.size()) {
      options.vertex_map = level.vertex_map;
    }
    const IndexedMesh& input = shown_ ? *shown_ : scene_.read.mesh;
    const double limit = shown_ ? distance : slack_of(level).within(distance);
    return metrics::certify(input, written, limit, options).verdict == Verdict::proven;
  }

 private:
  Slack slack_of(const Decimation& level) const {
    return {stretch_, widest_gap_as_written(output_, scene_, level.mesh)};
  }

  const Scene& scene_;
  const SceneOutput& output_;
  const SceneReadOptions& reading_;
  double stretch_;
  std::optional<IndexedMesh> shown_;
};

/// \param options a run by them may end early
std::vector<Level> levels_by_count(const Scene& scene, const LevelTargets& targets, Effort effort,
                                   const SimplifyOptions& options) {
  std::vector<Level> levels;
  for (Simplification& level : simplify_to_levels(scene.read.mesh, counts_of(targets, scene), effort, options)) {
    levels.push_back({std::move(level), std::nullopt, std::nullopt});
  }
  return levels;
}

/// \param options a run by them may end early
std::vector<Level> levels_by_error(const Scene& scene, const LevelTargets& targets, Effort effort,
                                   const SimplifyOptions& options, const LevelsProof& proof) {
  const std::vector<Limit> limits = limits_of(targets, scene);
  std::vector<double> errors;
  errors.reserve(limits.size());
  for (const Limit& limit : limits) errors.push_back(limit.error);
  const auto is_within = [&proof](const Decimation& level, double distance) {
    return proof.is_within(level, distance);
  };
  std::vector<progressive::ProvenLevel> proven =
      progressive::levels_within(scene.read.mesh, errors, effort, options, is_within);
  std::vector<Level> levels;
  for (std::size_t i = 0; i < proven.size(); ++i) {
    levels.push_back({std::move(proven[i]), limits[i].error, limits[i].distance});
  }
  return levels;
}

}  // namespace

double CameraView::error_over_distance() const {
  const double tangent = detail::cosine_of_deg(90 - fov_deg / 2) / detail::cosine_of_deg(fov_deg / 2);
  return 2 * tangent * error_rel();
}

Levels make_levels(const Scene& scene, const LevelTargets& targets, Effort effort, const SimplifyOptions& options,
                   const SceneOutput& output, const SceneReadOptions& reading) {
  check(targets);
  bool is_cancelled = false;
  SimplifyOptions watched = options;
  if (options.decimate.progress) {
    watched.decimate.progress = [&](const Progress& progress) {
      is_cancelled = is_cancelled || !options.decimate.progress(progress);
      return !is_cancelled;
    };
  }
  const bool is_by_error = !targets.errors.empty() || !targets.distances.empty();
  Levels levels;
  levels.levels = is_by_error ? levels_by_error(scene, targets, effort, watched, LevelsProof(scene, output, reading))
                              : levels_by_count(scene, targets, effort, watched);
  if (is_cancelled) throw Cancelled();
  if (!is_by_error) warn_of_missing_levels(scene, counts_of(targets, scene).size(), levels);
  warn_of_new_intersections(scene, options.decimate.threads, levels);
  return levels;
}

}  // namespace whittle
