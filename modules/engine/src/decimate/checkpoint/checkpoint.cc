#include <stdexcept>
#include <utility>

#include "decimate/checkpoint/changes.hh"
#include "decimate/checkpoint/line_courses.hh"
#include "decimate/checks.hh"
#include "decimate/input_lines.hh"
#include "decimate/staged_run.hh"
#include "loop/contraction_log.hh"

namespace whittle {
namespace {

/// A copy without what is for the next stage.
WorkingSurface geometry_alone(const WorkingSurface& surface) {
  WorkingSurface copy;
  copy.positions = surface.positions;
  copy.faces = surface.faces;
  copy.origins = surface.origins;
  copy.face_origins = surface.face_origins;
  copy.vertex_map = surface.vertex_map;
  copy.lines = surface.lines;
  copy.quadrics = surface.quadrics;
  return copy;
}

}  // namespace

/// \return which are elsewhere now, if steps are kept
std::vector<PassEnd::MovedVertex> StagedRun::put_vertices(std::vector<Vec3> positions) {
  WorkingSurface& surface = state_.surface;
  std::vector<PassEnd::MovedVertex> moved;
  for (Index v = 0; v < positions.size() && keeps_steps(); ++v) {
    if (positions[v] == surface.positions[v]) continue;
    const Index origin = surface.origins[v];
    moved.push_back({origin, to_output(positions[v], mesh_.positions[origin], frame_)});
  }
  surface.cost_state.move_origins(surface.positions.own(), positions);
  surface.positions = std::move(positions);
  return moved;
}

void StagedRun::move_vertices(std::vector<Vec3> positions) {
  std::vector<PassEnd::MovedVertex> moved = put_vertices(std::move(positions));
  if (keeps_steps()) report().steps.pass_ends.back().moved = std::move(moved);
}

bool StagedRun::checkpoint() {
  WorkingSurface& surface = state_.surface;
  Decimation paused = geometry_of(mesh_, geometry_alone(surface), frame_);
  paused.result = report().result;
  const std::vector<Vec3> before = paused.mesh.positions;
  const std::size_t n_faces = paused.mesh.faces.size();
  const bool goes_on = options_.pauses.adjust(paused);
  if (paused.mesh.positions.size() != before.size() || paused.mesh.faces.size() != n_faces) {
    throw std::invalid_argument("decimate: a pause changed the number of vertices or faces");
  }
  check(paused.mesh);
  PassEnd changes;
  if (keeps_steps()) {
    changes.turned = turned_faces(surface.faces, paused.mesh.faces, surface.origins, surface.face_origins);
  }
  surface.faces = std::move(paused.mesh.faces);
  std::vector<Vec3> positions(surface.positions.begin(), surface.positions.end());
  for (Index v = 0; v < before.size(); ++v) {
    if (paused.mesh.positions[v] != before[v]) positions[v] = frame_.to_frame(paused.mesh.positions[v]);
  }
  changes.moved = put_vertices(std::move(positions));
  if (!surface.lines.edges.empty()) find_courses(mesh_, frame_, input_features(mesh_, options_), surface);
  if (keeps_steps()) {
    changes.n_contractions = report().steps.contractions.size();
    report().steps.pass_ends.back() = std::move(changes);
  }
  return goes_on;
}

}  // namespace whittle
