#include "decimate/plain_run.hh"

#include <algorithm>
#include <numeric>
#include <utility>

namespace whittle {

PlainRun::PlainRun(Passes& passes, ErrorBounds& bounds, const BlockPlan& plan) : passes_(passes), bounds_(bounds) {
  const Done before = passes_.done();
  passes_.keep_steps_of_all(true);
  contract(passes_.target().or_faces(passes_.target().n_faces().value_or(1)), plan);
  passes_.keep_steps_of_all(false);
  if (passes_.is_cancelled()) return;
  const auto& contractions = passes_.done().steps.contractions;
  contractions_.assign(contractions.begin(), contractions.end());
  n_vertices_left_ = passes_.n_vertices_left();
  passes_.done() = before;
}

bool PlainRun::contract_to_coarsest_proven(std::size_t most_faces, const BlockPlan& plan) {
  constexpr std::size_t accuracy = 200;  // of the faces, two a contraction
  std::size_t least = 0;
  std::size_t most = contractions_.size() + 1;
  std::size_t n_faces = passes_.mesh().faces.size();
  bool is_found = proven_ > 0;
  while (most - least > std::max<std::size_t>(1, n_faces / accuracy)) {
    const std::size_t middle = least + (most - least) / 2;
    const Level level = level_after(middle);
    const bool is_of_use = middle > proven_ && level.mesh.faces.size() <= most_faces;
    if (is_of_use && !is_proven(level)) {
      most = middle;
      continue;
    }
    is_found |= is_of_use;
    least = middle;
    n_faces = level.mesh.faces.size();
  }
  if (!is_found) return false;
  least = std::max(least, proven_);
  const DecimateTarget& target = passes_.target();
  const std::uint64_t n_vertices = n_vertices_left_ + contractions_.size() - least;
  contract(target.or_vertices(std::max(n_vertices, target.n_vertices().value_or(0))), plan);
  return true;
}

/// Of the input.
void PlainRun::contract(const DecimateTarget& stop, const BlockPlan& plan) {
  const double progress = passes_.done().progress;
  passes_.forget_all();
  passes_.done().progress = progress;
  passes_.set_limits({});
  passes_.contract_in_blocks(stop, plan);
  passes_.contract_to(stop, false);
}

PlainRun::Level PlainRun::level_after(std::size_t n_contractions) const {
  const IndexedMesh& input = passes_.mesh();
  Level level;
  level.mesh.positions = input.positions;
  level.vertex_map.resize(input.positions.size());
  std::iota(level.vertex_map.begin(), level.vertex_map.end(), Index{0});
  for (std::size_t i = 0; i < n_contractions; ++i) {
    level.vertex_map[contractions_[i].removed] = contractions_[i].survivor;
    level.mesh.positions[contractions_[i].survivor] = contractions_[i].position;
  }
  // What a vertex was merged into may have been merged later: those are followed from the last one on.
  for (std::size_t i = n_contractions; i-- > 0;) {
    Index& become = level.vertex_map[contractions_[i].removed];
    become = level.vertex_map[become];
  }
  for (const Triangle& face : input.faces) {
    const Triangle left{level.vertex_map[face[0]], level.vertex_map[face[1]], level.vertex_map[face[2]]};
    if (has_three_corners(left)) level.mesh.faces.push_back(left);
  }
  return level;
}

bool PlainRun::is_proven_with_vertices(std::size_t n_vertices) {
  const std::size_t n_before = n_vertices_left_ + contractions_.size();
  const std::size_t n_contractions = std::min(n_before - std::min(n_before, n_vertices), contractions_.size());
  const bool is_so = is_proven(level_after(n_contractions));
  if (is_so) proven_ = n_contractions;
  return is_so;
}

bool PlainRun::is_proven(const Level& level) const {
  return bounds_.are_kept_by({level.mesh, passes_.frame(), level.vertex_map});
}

}  // namespace whittle
