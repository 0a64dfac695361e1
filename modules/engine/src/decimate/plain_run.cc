#include "decimate/plain_run.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "whittle/engine/detail/bisect.hh"

namespace whittle {

PlainRun::PlainRun(StagedRun& run, ErrorBounds& bounds, const BlockPlan& plan)
    : run_(run), bounds_(bounds), start_(run.state()) {
  run_.keep_steps_of_all(true);
  contract(run_.target().or_faces(run_.target().n_faces().value_or(1)), plan);
  run_.keep_steps_of_all(false);
  if (run_.is_cancelled()) return;
  const auto& contractions = run_.report().steps.contractions;
  const auto n_before = static_cast<std::ptrdiff_t>(start_.report.steps.contractions.size());
  contractions_.assign(contractions.begin() + n_before, contractions.end());
  n_vertices_left_ = run_.n_vertices_left();
  run_.return_to(start_);
}

bool PlainRun::contract_to_coarsest_proven(std::size_t most_faces, const BlockPlan& plan) {
  constexpr std::size_t accuracy = 200;  // of the faces, two a contraction
  std::size_t n_faces = run_.mesh().faces.size();
  const auto gap = [&] { return std::max<std::size_t>(1, n_faces / accuracy); };
  std::size_t found = proven_;
  const auto holds = [&](std::size_t n_contractions, const auto& predicate) {
    const Level level = level_after(n_contractions);
    const bool is_of_use = n_contractions > proven_ && level.mesh.faces.size() <= most_faces;
    if (is_of_use && !predicate(level)) return false;
    n_faces = level.mesh.faces.size();
    return true;
  };
  // A point that is far is found in no time, and a proof takes long.
  const auto seems_near = [&](std::size_t n_contractions) {
    return holds(n_contractions, [this](const Level& level) { return !bounds_.have_far_point(checked(level)); });
  };
  const auto is_near = [&](std::size_t n_contractions) {
    return holds(n_contractions, [&](const Level& level) {
      if (!bounds_.are_kept_by(checked(level))) return false;
      found = std::max(found, n_contractions);
      return true;
    });
  };
  const std::size_t first = detail::bisect(0, contractions_.size() + 1, gap, seems_near);
  detail::bisect_from_end(first + 1, gap, is_near);
  if (found == 0) return false;
  const DecimateTarget& target = run_.target();
  const std::uint64_t n_vertices = n_vertices_left_ + contractions_.size() - found;
  contract(target.or_vertices(std::max(n_vertices, target.n_vertices().value_or(0))), plan);
  return true;
}

/// From the start.
void PlainRun::contract(const DecimateTarget& stop, const BlockPlan& plan) {
  const double progress = run_.report().progress;
  run_.return_to(start_);
  run_.report().progress = progress;
  run_.contract_in_blocks(stop, plan);
  run_.contract(stop, false);
}

/// Over the input's vertices, as contractions are told.
PlainRun::Level PlainRun::start_level() const {
  const IndexedMesh& input = run_.mesh();
  const WorkingSurface& start = start_.surface;
  Level level;
  level.mesh.positions = input.positions;
  level.vertex_map.resize(input.positions.size());
  std::iota(level.vertex_map.begin(), level.vertex_map.end(), Index{0});
  if (start.is_input()) {
    level.mesh.faces = input.faces;
    return level;
  }
  for (Index v = 0; v < start.positions.size(); ++v) {
    level.mesh.positions[start.origins[v]] = run_.frame().to_model(start.positions[v]);
  }
  for (Index& v : level.vertex_map) {
    v = start.vertex_map[v] == invalid_index ? invalid_index : start.origins[start.vertex_map[v]];
  }
  for (const Triangle& face : start.faces) level.mesh.faces.push_back(mapped(face, start.origins));
  return level;
}

PlainRun::Level PlainRun::level_after(std::size_t n_contractions) const {
  Level level = start_level();
  std::vector<Index> become(level.vertex_map.size());
  std::iota(become.begin(), become.end(), Index{0});
  for (std::size_t i = 0; i < n_contractions; ++i) {
    become[contractions_[i].removed] = contractions_[i].survivor;
    level.mesh.positions[contractions_[i].survivor] = contractions_[i].position;
  }
  // What a vertex was merged into may have been merged later: those are followed from the last one on.
  for (std::size_t i = n_contractions; i-- > 0;) {
    Index& its = become[contractions_[i].removed];
    its = become[its];
  }
  for (Index& v : level.vertex_map) {
    if (v != invalid_index) v = become[v];
  }
  for (Triangle& face : level.mesh.faces) face = mapped(face, become);
  std::erase_if(level.mesh.faces, [](const Triangle& face) { return !has_three_corners(face); });
  return level;
}

bool PlainRun::is_proven_with_vertices(std::size_t n_vertices) {
  const std::size_t n_before = n_vertices_left_ + contractions_.size();
  const std::size_t n_contractions = std::min(n_before - std::min(n_before, n_vertices), contractions_.size());
  const bool is_so = bounds_.are_kept_by(checked(level_after(n_contractions)));
  if (is_so) proven_ = n_contractions;
  return is_so;
}

CheckedSurface PlainRun::checked(const Level& level) const { return {level.mesh, run_.frame(), level.vertex_map}; }

}  // namespace whittle
