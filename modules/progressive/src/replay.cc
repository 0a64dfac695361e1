#include "whittle/progressive/replay.hh"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "replay_indexer.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/two_sided.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/polish/fit_attributes.hh"
#include "without_backs.hh"

namespace whittle::progressive {
namespace {

void check(const IndexedMesh& mesh) {
  if (mesh.faces.size() > invalid_index / 3) throw std::length_error("replay: more than 2^32 / 3 faces");
  const auto require = [](bool is_so, const char* what) {
    if (!is_so) throw std::invalid_argument(std::string("replay: the input ") + what);
  };
  const std::size_t n = mesh.positions.size();
  const auto has_vertices = [n](const Triangle& face) { return *std::max_element(face.begin(), face.end()) < n; };
  require(std::all_of(mesh.faces.begin(), mesh.faces.end(), has_vertices), "has a face with a vertex that isn't there");
  require(std::all_of(mesh.positions.begin(), mesh.positions.end(), is_position),
          "has a coordinate that isn't finite, or is above 3e150");
  check_attributes(mesh, "replay");
  require(mesh.origins.empty() || mesh.origins.size() == n, "has origins of a wrong length");
}

}  // namespace

Replay::Replay(IndexedMesh input, RunSteps steps, Normals normals)
    : input_(std::move(input)),
      steps_(std::move(steps)),
      normals_(normals),
      positions_(input_.positions.begin(), input_.positions.end()),
      corners_(input_.faces.begin(), input_.faces.end()),
      is_hidden_(input_.faces.size()) {
  check(input_);
  without_backs_ = make_without_backs(input_, steps_, normals_);
  ReplayIndexer(*this).run();
}

std::shared_ptr<Replay::WithoutBacks> Replay::make_without_backs(const IndexedMesh& input, const RunSteps& steps,
                                                                 Normals normals) {
  if (fronts_of_backs(input).empty()) return nullptr;
  auto owned = std::make_unique<IndexedMesh>(input);
  auto sheets = std::make_unique<TwoSidedSheets>(*owned);
  Replay replay(sheets->without_backs(), sheets->steps_without_backs(steps), normals);
  return std::make_shared<WithoutBacks>(WithoutBacks{std::move(owned), std::move(sheets), std::move(replay)});
}

// Which level ---------------------------------------------------------------------------------------------------------

std::size_t Replay::level_after(std::size_t n_contractions) const {
  n_contractions = std::min(n_contractions, steps_.contractions.size());
  const auto is_before = [](std::size_t n, const PassEnd& end) { return n < end.n_contractions; };
  const auto end = std::upper_bound(steps_.pass_ends.begin(), steps_.pass_ends.end(), n_contractions, is_before);
  return n_contractions + static_cast<std::size_t>(end - steps_.pass_ends.begin());
}

std::optional<std::size_t> Replay::level_of_faces(std::uint64_t n_faces) const {
  const auto found = std::partition_point(counts_.begin(), counts_.end(),
                                          [n_faces](const Counts& counts) { return counts.n_faces > n_faces; });
  if (found == counts_.end()) return std::nullopt;
  return level_after(static_cast<std::size_t>(found - counts_.begin()));
}

std::optional<std::size_t> Replay::level_of_vertices(std::uint64_t n_vertices) const {
  const auto found = std::partition_point(
      counts_.begin(), counts_.end(), [n_vertices](const Counts& counts) { return counts.n_vertices > n_vertices; });
  if (found == counts_.end()) return std::nullopt;
  return level_after(static_cast<std::size_t>(found - counts_.begin()));
}

std::size_t Replay::level_of_cost(double cost) const {
  const auto found = std::partition_point(counts_.begin() + 1, counts_.end(),
                                          [cost](const Counts& counts) { return counts.cost <= cost; });
  return level_after(static_cast<std::size_t>(found - counts_.begin()) - 1);
}

std::size_t Replay::level_at(double share) const {
  const auto n = static_cast<double>(steps_.contractions.size());
  return level_after(static_cast<std::size_t>(std::llround(std::clamp(share, 0.0, 1.0) * n)));
}

// Steps ---------------------------------------------------------------------------------------------------------------

void Replay::go_to(std::size_t level) {
  if (level > n_steps()) throw std::out_of_range("replay: there is no such level");
  while (this->level() < level) is_pass_end_next() ? end_pass() : contract();
  while (this->level() > level) is_pass_end_last() ? undo_pass_end() : undo_contraction();
}

void Replay::contract() {
  const Contraction& contraction = steps_.contractions[n_contractions_];
  positions_[contraction.survivor] = contraction.position;
  for (const Index c : undo_log_.corners_of(n_contractions_)) corners_[c / 3][c % 3] = contraction.survivor;
  apply_visibility();
  ++n_contractions_;
}

void Replay::undo_contraction() {
  --n_contractions_;
  const Contraction& contraction = steps_.contractions[n_contractions_];
  undo_visibility();
  positions_[contraction.survivor] = undo_log_.positions[n_contractions_];
  for (const Index c : undo_log_.corners_of(n_contractions_)) corners_[c / 3][c % 3] = contraction.removed;
}

void Replay::end_pass() {
  const PassEnd& end = steps_.pass_ends[n_pass_ends_];
  apply_visibility();
  for (const auto& [vertex, position] : end.moved) positions_[vertex] = position;
  for (const auto& [face, corners] : end.turned) corners_[face] = corners;
  ++n_pass_ends_;
}

void Replay::undo_pass_end() {
  --n_pass_ends_;
  const PassEnd& end = steps_.pass_ends[n_pass_ends_];
  const PassBefore& before = undo_log_.passes[n_pass_ends_];
  for (std::size_t i = end.turned.size(); i-- > 0;) corners_[end.turned[i].face] = before.corners[i];
  for (std::size_t i = end.moved.size(); i-- > 0;) positions_[end.moved[i].vertex] = before.positions[i];
  undo_visibility();
}

/// Does the visibility changes of the step at the current level.
void Replay::apply_visibility() {
  for (; n_visibility_changes_ < undo_log_.visibility.size(); ++n_visibility_changes_) {
    const auto& [step, face, is_hidden] = undo_log_.visibility[n_visibility_changes_];
    if (step != level()) return;
    is_hidden_[face] = is_hidden ? 1 : 0;
  }
}

void Replay::undo_visibility() {
  for (; n_visibility_changes_ > 0; --n_visibility_changes_) {
    const auto& [step, face, is_hidden] = undo_log_.visibility[n_visibility_changes_ - 1];
    if (step != level()) return;
    is_hidden_[face] = is_hidden ? 0 : 1;
  }
}

// The surface ---------------------------------------------------------------------------------------------------------

std::vector<Index> Replay::survivors() const {
  std::vector<Index> survivors(input_.positions.size());
  for (Index v = 0; v < survivors.size(); ++v) survivors[v] = v;
  for (std::size_t i = n_contractions_; i-- > 0;) {
    survivors[steps_.contractions[i].removed] = survivors[steps_.contractions[i].survivor];
  }
  return survivors;
}

std::vector<Index> Replay::faces_left() const {
  std::vector<Index> faces;
  faces.reserve(n_faces());
  for (Index f = 0; f < corners_.size(); ++f) {
    if (has_face(f)) faces.push_back(f);
  }
  return faces;
}

/// Carries attributes as the run did: by positions before the last pass of polish, except recomputed normals. At the
/// last level they may be fitted.
void Replay::add_attributes(const std::vector<Index>& numbers, Decimation& out) const {
  carry_attributes_to(numbers, out);
  if (steps_.fits_attributes && level() == n_steps()) {
    fit_attributes(input_, wedge_map(input_, out.vertex_map, out.face_origins), out.mesh,
                   {.fit_normals = normals_ == Normals::keep});
  }
  break_normals(Frame::of_points(input_.positions), normals_, steps_.crease_angle_deg, out.mesh);
}

void Replay::carry_attributes_to(const std::vector<Index>& numbers, Decimation& out) const {
  const Frame frame = Frame::of_points(input_.positions);
  const bool is_polished = is_pass_end_last() && n_pass_ends_ == steps_.pass_ends.size();
  if (!is_polished || normals_ == Normals::recompute || input_.normals.empty()) {
    carry_attributes(input_, frame, normals_, out.vertex_map, out.face_origins, out.mesh);
    return;
  }
  IndexedMesh mesh = out.mesh;
  const PassEnd& end = steps_.pass_ends.back();
  const PassBefore& before = undo_log_.passes.back();
  for (std::size_t i = end.moved.size(); i-- > 0;) {
    const Index v = numbers[end.moved[i].vertex];
    if (v != invalid_index) mesh.positions[v] = before.positions[i];
  }
  for (std::size_t i = end.turned.size(); i-- > 0;) {
    const auto face = std::lower_bound(out.face_origins.begin(), out.face_origins.end(), end.turned[i].face);
    const auto& [a, b, c] = before.corners[i];
    mesh.faces[static_cast<std::size_t>(face - out.face_origins.begin())] = {numbers[a], numbers[b], numbers[c]};
  }
  carry_attributes(input_, frame, normals_, out.vertex_map, out.face_origins, mesh);
  mesh.positions = std::move(out.mesh.positions);
  mesh.faces = std::move(out.mesh.faces);
  out.mesh = std::move(mesh);
}

Decimation Replay::decimation_with_backs() const {
  Replay& replay = without_backs_->replay;
  replay.go_to(level());
  Decimation out = replay.decimation();
  without_backs_->sheets->add_backs(normals_, 0, out);
  out.steps = {};
  out.result.before = out.result.after = {};
  return out;
}

Decimation Replay::decimation() const {
  if (without_backs_) return decimation_with_backs();
  Decimation out;
  out.face_origins = faces_left();
  std::vector<Index> numbers(positions_.size(), invalid_index);
  for (const Index f : out.face_origins) {
    for (const Index v : corners_[f]) numbers[v] = 0;
  }
  IndexedMesh& mesh = out.mesh;
  for (Index v = 0; v < numbers.size(); ++v) {
    if (numbers[v] == invalid_index) continue;
    numbers[v] = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(positions_[v]);
    mesh.origins.push_back(input_.origins.empty() ? v : input_.origins[v]);
  }
  for (const Index f : out.face_origins) {
    const auto& [a, b, c] = corners_[f];
    mesh.faces.push_back({numbers[a], numbers[b], numbers[c]});
  }
  out.vertex_map = survivors();
  for (Index& v : out.vertex_map) v = numbers[v];
  add_attributes(numbers, out);
  out.result.n_contractions = n_contractions_;
  out.result.n_vertices = n_vertices();
  out.result.n_faces = n_faces();
  out.result.max_cost = cost();
  return out;
}

std::vector<std::size_t> levels_of_curve(const Replay& replay) {
  constexpr double step = 0.75;
  std::vector<std::size_t> levels{0};
  for (auto n = static_cast<double>(replay.input().faces.size()) * step; n >= 1; n *= step) {
    const auto level = replay.level_of_faces(static_cast<std::uint64_t>(n));
    if (!level) break;
    if (*level > levels.back()) levels.push_back(*level);
  }
  if (levels.back() != replay.n_steps()) levels.push_back(replay.n_steps());
  return levels;
}

}  // namespace whittle::progressive
