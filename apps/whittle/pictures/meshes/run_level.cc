#include "pictures/meshes/run_level.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "whittle/core/wedges.hh"
#include "whittle/progressive/geomorph.hh"

namespace whittle::app {
namespace {

/// \param place [0, 1]
std::size_t level_at(const progressive::Replay& run, double place, bool is_by_faces) {
  if (!is_by_faces) return run.level_at(place);
  if (place <= 0) return run.level_after(0);
  if (place >= 1) return run.n_steps();
  const auto first = static_cast<double>(run.n_faces_after(0));
  const auto last = static_cast<double>(std::max<std::uint64_t>(1, run.n_faces_after(run.steps().contractions.size())));
  const double n_faces = std::round(first * std::pow(last / first, place));
  return run.level_of_faces(static_cast<std::uint64_t>(n_faces)).value_or(run.n_steps());
}

IndexedMesh mesh_at(progressive::Replay& run, std::size_t level) {
  run.go_to(level);
  IndexedMesh mesh;
  mesh.positions.reserve(run.input().positions.size());
  for (Index v = 0; v < run.input().positions.size(); ++v) mesh.positions.push_back(run.position(v));
  mesh.faces.reserve(run.n_faces());
  for (Index f = 0; f < run.input().faces.size(); ++f) {
    if (run.has_face(f)) mesh.faces.push_back(run.corners(f));
  }
  return mesh;
}

/// Between a hundred stops, vertices go from one level to the next.
IndexedMesh mesh_between(progressive::Replay& run, const PictureView& view) {
  constexpr double n_stops = 100;
  const double stop = std::min(n_stops - 1, std::floor(view.level * n_stops));
  const double share = view.level * n_stops - stop;
  const std::size_t from = level_at(run, stop / n_stops, view.is_by_faces);
  const std::size_t to = level_at(run, (stop + 1) / n_stops, view.is_by_faces);
  if (share <= 0) return mesh_at(run, from);
  if (share >= 1 || from >= to) return mesh_at(run, to);
  try {
    return without_attributes(progressive::Geomorph(run, from, to).at(share));
  } catch (const std::invalid_argument&) {  // polish flips edges
    return mesh_at(run, from);
  }
}

}  // namespace

ShownSurface level_of_run(progressive::Replay& run, const PictureView& view) {
  ShownSurface level;
  level.name = "level of the run";
  level.mesh = view.is_continuous ? mesh_between(run, view) : mesh_at(run, level_at(run, view.level, view.is_by_faces));
  return level;
}

}  // namespace whittle::app
