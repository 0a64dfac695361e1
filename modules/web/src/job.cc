#include "whittle/web/job.hh"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "whittle/core/geometry/box.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/wedges.hh"
#include "whittle/progressive/replay.hh"

namespace whittle::web {

/// The mesh to simplify, and where the given rows and faces went.
struct Joined {
  IndexedMesh mesh;
  std::vector<Index> vertex_map;
};

struct RecordedRun {
  std::vector<Index> vertex_map;  ///< of the joined mesh
  JobReport report;               ///< of the last level
  progressive::Replay replay;
};

namespace {

/// −1 where there is none.
constexpr double no_error = -1;

bool precedes(const Vec3& p, const Vec3& q) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] != q[axis]) return p[axis] < q[axis];
  }
  return false;
}

/// \throw std::invalid_argument for what joining can't bear; `simplify` checks the rest
void check(const IndexedMesh& mesh) {
  for (const Vec3& p : mesh.positions) {
    if (!p.allFinite()) throw std::invalid_argument("a position isn't finite");
  }
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) {
      if (v >= mesh.positions.size()) {
        throw std::invalid_argument("there is no vertex " + std::to_string(v) + ", which a face has");
      }
    }
  }
}

Joined joined(const Job& job) {
  check(job.mesh);
  Joined result{job.mesh, {}};
  IndexedMesh& mesh = result.mesh;
  mesh.origins.resize(mesh.positions.size());
  std::iota(mesh.origins.begin(), mesh.origins.end(), Index{0});
  result.vertex_map = join_vertices(mesh, first_of_same_position(mesh.positions));
  if (job.settings.prune) {
    const double size = job.settings.prune->in_units(diagonal_of(mesh.positions));
    PrunedMesh pruned = without_small_parts(std::move(mesh), size);
    for (Index& v : result.vertex_map) v = pruned.vertex_map[v];
    mesh = std::move(pruned.mesh);
  }
  return result;
}

/// 0 without faces.
double diagonal_of(const Joined& joined) {
  return joined.mesh.faces.empty() ? 0 : whittle::diagonal_of(joined.mesh.positions);
}

SimplifyOptions settled(const Job& job, const Joined& joined, double diagonal) {
  SimplifyOptions options = job.settings.options;
  DecimateOptions& decimate = options.decimate;
  decimate.threads = 1;
  if (job.settings.threshold && diagonal > 0) {
    const double threshold = job.settings.threshold->in_units(diagonal);
    if (threshold > 0) decimate.pairs.threshold = threshold;
  }
  if (diagonal > 0) decimate.feature_tolerance = job.settings.feature_tolerance.in_units(diagonal) / diagonal;
  if (!job.locked.empty()) {
    decimate.locked.resize(joined.mesh.positions.size());
    for (std::size_t row = 0; row < job.locked.size(); ++row) {
      const Index v = joined.vertex_map[row];
      if (job.locked[row] != 0 && v != invalid_index) decimate.locked[v] = 1;
    }
  }
  return options;
}

/// For each given row one of the vertices of the split mesh. \param map of rows to vertices before the run
std::vector<Index> map_of_rows(std::vector<Index> map, const Decimation& small, const IndexedMesh& split) {
  std::vector<Index> first(small.mesh.positions.size(), invalid_index);
  for (std::size_t f = 0; f < split.faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      Index& vertex = first[small.mesh.faces[f][c]];
      vertex = std::min(vertex, split.faces[f][c]);
    }
  }
  for (Index& v : map) {
    if (v != invalid_index) v = small.vertex_map[v];
    if (v != invalid_index) v = first[v];
  }
  return map;
}

JobReport report_of(const Joined& joined, const Simplification& result) {
  JobReport report;
  report.n_vertices_before = static_cast<double>(joined.mesh.positions.size());
  report.n_faces_before = static_cast<double>(joined.mesh.faces.size());
  report.stop = static_cast<double>(result.result.stop);
  report.max_cost = result.result.max_cost;
  report.proven_error = result.result.proven_error.value_or(no_error);
  report.n_contractions = static_cast<double>(result.result.n_contractions);
  report.n_folded_texture_faces = static_cast<double>(result.n_folded_texture_faces);
  return report;
}

DecimateTarget target_of(const Job& job, const Joined& joined, double diagonal) {
  if (!job.settings.has_target()) throw std::invalid_argument("no target: give at least one");
  return job.settings.target(joined.mesh.positions.size(), joined.mesh.faces.size(), diagonal);
}

std::vector<Simplification> run(const Job& job, const Joined& joined) {
  const double diagonal = diagonal_of(joined);
  const SimplifyOptions options = settled(job, joined, diagonal);
  if (!job.levels.empty()) {
    std::vector<DecimateTarget> targets;
    for (const std::uint64_t n : job.levels) targets.push_back(DecimateTarget::faces(n));
    return simplify_to_levels(joined.mesh, targets, job.settings.effort, options);
  }
  std::vector<Simplification> result;
  result.push_back(whittle::simplify(joined.mesh, target_of(job, joined, diagonal), job.settings.effort, options));
  return result;
}

}  // namespace

std::vector<Index> first_of_same_position(std::span<const Vec3> positions) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index v, Index w) {
    if (precedes(positions[v], positions[w])) return true;
    return !precedes(positions[w], positions[v]) && v < w;
  });
  std::vector<Index> first(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || precedes(positions[order[i - 1]], positions[order[i]]);
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

void Job::simplify() {
  const Joined input = joined(*this);
  std::vector<Simplification> levels = run(*this, input);
  results.clear();
  for (const Simplification& level : levels) results.push_back(split_at_wedges(level.mesh));
  report = report_of(input, levels.back());
  vertex_map = map_of_rows(input.vertex_map, levels.back(), results.back());
  face_origins = std::move(levels.back().face_origins);
}

void Job::record() {
  Joined input = joined(*this);
  const double diagonal = diagonal_of(input);
  SimplifyOptions options = settled(*this, input, diagonal);
  options.decimate.keep_steps = true;
  Simplification last = whittle::simplify(input.mesh, target_of(*this, input, diagonal), settings.effort, options);
  const JobReport of_last = report_of(input, last);
  progressive::Replay replay(std::move(input.mesh), std::move(last.steps), options.decimate.normals);
  recorded = std::make_shared<RecordedRun>(RecordedRun{std::move(input.vertex_map), of_last, std::move(replay)});
  take_level(0, false);
}

void Job::take_level(std::uint64_t n, bool counts_vertices) {
  progressive::Replay& replay = recorded->replay;
  const auto level = counts_vertices ? replay.level_of_vertices(n) : replay.level_of_faces(n);
  replay.go_to(level.value_or(replay.n_steps()));
  Decimation small = replay.decimation();
  results.assign(1, split_at_wedges(small.mesh));
  report = recorded->report;
  report.max_cost = replay.cost();
  report.n_contractions = static_cast<double>(replay.n_contractions());
  if (replay.level() < replay.n_steps()) report.proven_error = no_error;
  vertex_map = map_of_rows(recorded->vertex_map, small, results.back());
  face_origins = std::move(small.face_origins);
}

double Job::simplify_indices(std::size_t n_faces, double max_distance, bool may_open_seams) {
  check(mesh);
  DecimateOptions options = settings.options.decimate;
  options.threads = 1;
  options.quadric.weights = Weights::uniform;
  options.locked = locked;
  if (!may_open_seams) {
    const std::vector<Index> first = first_of_same_position(mesh.positions);
    options.locked.resize(mesh.positions.size());
    for (Index v = 0; v < first.size(); ++v) {
      if (first[v] != v) options.locked[v] = options.locked[first[v]] = 1;
    }
  }
  DecimateTarget target = DecimateTarget::faces(n_faces);
  const double max_cost = max_distance * max_distance;
  if (std::isfinite(max_cost)) target = target.or_max_cost(max_cost);
  IndexOnlyDecimation small = decimate_index_only(mesh, target, options);
  results.assign(1, {});
  results.front().faces = std::move(small.faces);
  vertex_map = std::move(small.vertex_map);
  face_origins = std::move(small.face_origins);
  return std::sqrt(std::max(0.0, small.result.max_cost));
}

}  // namespace whittle::web
