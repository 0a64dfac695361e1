#include "replay_indexer.hh"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "without_backs.hh"

namespace whittle::progressive {
namespace {

/// The face rotated to begin with its lowest corner.
Triangle from_lowest(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// A face at the survivor.
struct StarFace {
  Index low, high;       ///< the other two corners
  bool is_turned;        ///< whether the higher one comes first
  bool was_at_survivor;  ///< whether it was there before the contraction
  Index face;

  auto edge() const { return std::pair(low, high); }
  bool operator<(const StarFace& other) const {
    return std::tie(low, high, is_turned, face) < std::tie(other.low, other.high, other.is_turned, other.face);
  }
};

}  // namespace

ReplayIndexer::ReplayIndexer(Replay& replay)
    : replay_(replay),
      undo_log_(replay.undo_log_),
      is_removed_(replay.input().positions.size()),
      n_faces_at_(replay.input().positions.size(), 0) {
  for (const Triangle& face : replay_.corners_) {
    if (has_three_corners(face)) count_face(face, 1);
  }
  list_corners();
}

void ReplayIndexer::run() {
  const RunSteps& steps = replay_.steps_;
  replay_.counts_.reserve(steps.contractions.size() + 1);
  undo_log_.positions.reserve(steps.contractions.size());
  undo_log_.corners.reserve(std::min(6 * steps.contractions.size(), 3 * replay_.corners_.size()));
  undo_log_.first_corner.reserve(steps.contractions.size() + 1);
  replay_.counts_.push_back({0, static_cast<Index>(n_vertices_), static_cast<Index>(n_faces_)});
  undo_log_.first_corner.push_back(0);
  for (const PassEnd& end : steps.pass_ends) {
    require(end.n_contractions >= replay_.n_contractions_ && end.n_contractions <= steps.contractions.size(),
            "passes end in order, after contractions that are there");
    while (replay_.n_contractions_ < end.n_contractions) contract(steps.contractions[replay_.n_contractions_]);
    end_pass(end);
  }
  while (replay_.n_contractions_ < steps.contractions.size()) contract(steps.contractions[replay_.n_contractions_]);
}

void ReplayIndexer::require(bool is_so, const char* what) const {
  if (is_so) return;
  throw std::invalid_argument("step " + std::to_string(replay_.level()) + " can't be made: " + what);
}

/// Lists the corners of visible faces. Other faces never come back.
void ReplayIndexer::list_corners() {
  first_.assign(replay_.positions_.size(), invalid_index);
  next_.assign(3 * replay_.corners_.size(), invalid_index);
  for (Index c = 0; c < next_.size(); ++c) {
    if (replay_.has_face(c / 3)) list_corner(c);
  }
}

void ReplayIndexer::list_corner(Index corner) {
  Index& first = first_[replay_.corners_[corner / 3][corner % 3]];
  next_[corner] = std::exchange(first, corner);
}

void ReplayIndexer::count_face(const Triangle& face, int change) {
  n_faces_ += static_cast<std::uint64_t>(change);
  for (const Index v : face) {
    n_vertices_ -= static_cast<std::uint64_t>(n_faces_at_[v] > 0);
    n_faces_at_[v] += static_cast<Index>(change);
    n_vertices_ += static_cast<std::uint64_t>(n_faces_at_[v] > 0);
  }
}

// Contractions --------------------------------------------------------------------------------------------------------

void ReplayIndexer::check(const Contraction& contraction) const {
  require(is_there(contraction.survivor) && is_there(contraction.removed), "a vertex isn't there");
  require(contraction.survivor != contraction.removed, "a vertex is merged into itself");
  require(is_position(contraction.position), "a position isn't finite, or is above 3e150");
  require(!std::isnan(contraction.cost), "a cost is no number");
}

void ReplayIndexer::contract(const Contraction& contraction) {
  check(contraction);
  Vec3& position = replay_.positions_[contraction.survivor];
  undo_log_.positions.push_back(std::exchange(position, contraction.position));
  move_corners(contraction);
  if (replay_.without_backs_) {
    hide_as_without_backs();
  } else {
    if (contraction.joins_faces) hide_coincident(contraction.survivor);
    show_first_ones(contraction.survivor);
  }
  is_removed_[contraction.removed] = true;
  const double cost = std::max(replay_.counts_.back().cost, contraction.cost);
  replay_.counts_.push_back({cost, static_cast<Index>(n_vertices_), static_cast<Index>(n_faces_)});
  undo_log_.first_corner.push_back(undo_log_.corners.size());
  ++replay_.n_contractions_;
}

/// Moves corners from the removed vertex to the survivor. Corners of vanished faces keep their vertex and leave the
/// lists.
void ReplayIndexer::move_corners(const Contraction& contraction) {
  const auto& [survivor, removed, position, cost, is_threshold_pair, joins_faces] = contraction;
  for (Index c = std::exchange(first_[removed], invalid_index); c != invalid_index;) {
    const Index next = next_[c];
    Triangle& corners = replay_.corners_[c / 3];
    if (has_three_corners(corners)) {
      const bool vanishes = corners[0] == survivor || corners[1] == survivor || corners[2] == survivor;
      if (vanishes && replay_.is_hidden_[c / 3] == 0) count_face(corners, -1);
      corners[c % 3] = survivor;
      undo_log_.corners.push_back(c);
      list_corner(c);
    }
    c = next;
  }
  n_vertices_ -=
      static_cast<std::uint64_t>(n_faces_at_[survivor] > 0) + static_cast<std::uint64_t>(n_faces_at_[removed] > 0);
  n_faces_at_[survivor] += std::exchange(n_faces_at_[removed], 0);
  n_vertices_ += static_cast<std::uint64_t>(n_faces_at_[survivor] > 0);
}

/// Leaves one of coincident faces, or none (see `Contraction::joins_faces`).
void ReplayIndexer::hide_coincident(Index survivor) {
  const std::span<const Index> moved = std::span(undo_log_.corners).subspan(undo_log_.first_corner.back());
  std::vector<StarFace> star;
  for (Index c = first_[survivor]; c != invalid_index; c = next_[c]) {
    const Triangle& corners = replay_.corners_[c / 3];
    if (!replay_.has_face(c / 3)) continue;
    const Index x = corners[(c % 3 + 1) % 3];
    const Index y = corners[(c % 3 + 2) % 3];
    const bool is_moved = std::find(moved.begin(), moved.end(), c) != moved.end();
    star.push_back({std::min(x, y), std::max(x, y), x > y, !is_moved, c / 3});
  }
  std::sort(star.begin(), star.end());
  for (auto begin = star.begin(), end = begin; begin != star.end(); begin = end) {
    end = std::find_if(begin, star.end(), [&](const StarFace& face) { return face.edge() != begin->edge(); });
    const auto n_before = std::count_if(begin, end, [](const StarFace& face) { return face.was_at_survivor; });
    if (n_before == 0 || n_before == end - begin) continue;
    const auto turned = std::find_if(begin, end, [](const StarFace& face) { return face.is_turned; });
    const auto surplus = (end - turned) - (turned - begin);
    const auto left = surplus == 0 ? end : surplus > 0 ? turned : begin;
    for (auto face = begin; face != end; ++face) {
      if (face != left) set_hidden(face->face, true);
    }
  }
}

/// Shows the first of coincident faces at the survivor, as a run does.
void ReplayIndexer::show_first_ones(Index survivor) {
  if (!is_any_hidden_) return;
  bool is_any_here = false;
  for (Index c = first_[survivor]; c != invalid_index; c = next_[c]) is_any_here |= replay_.is_hidden_[c / 3] != 0;
  if (!is_any_here) return;
  std::map<Triangle, std::vector<Index>> alike;
  for (Index c = first_[survivor]; c != invalid_index; c = next_[c]) {
    const Triangle& corners = replay_.corners_[c / 3];
    if (has_three_corners(corners)) alike[from_lowest(corners)].push_back(c / 3);
  }
  for (auto& [corners, faces] : alike) {
    const auto n_there = std::count_if(faces.begin(), faces.end(), [this](Index f) { return replay_.has_face(f); });
    std::sort(faces.begin(), faces.end());
    const auto first_hidden = faces.begin() + n_there;
    std::for_each(faces.begin(), first_hidden, [this](Index f) { set_hidden(f, false); });
    std::for_each(first_hidden, faces.end(), [this](Index f) { set_hidden(f, true); });
  }
}

void ReplayIndexer::set_hidden(Index face, bool is_hidden) {
  if ((replay_.is_hidden_[face] != 0) == is_hidden) return;
  replay_.is_hidden_[face] = is_hidden ? 1 : 0;
  undo_log_.visibility.push_back({replay_.level(), face, is_hidden});
  ++replay_.n_visibility_changes_;
  is_any_hidden_ |= is_hidden;
  count_face(replay_.corners_[face], is_hidden ? -1 : 1);
}

/// Takes visibility changes of fronts over from the replay without backs. Backs follow their fronts.
void ReplayIndexer::hide_as_without_backs() {
  const auto& [input, sheets, without_backs] = *replay_.without_backs_;
  for (; n_followed_ < without_backs.visibility_changes().size(); ++n_followed_) {
    const auto& [step, of_fronts, is_hidden] = without_backs.visibility_changes()[n_followed_];
    if (step != replay_.level()) break;
    for (const Index face : {sheets->front_of(of_fronts), sheets->back_of(of_fronts)}) {
      if (face != invalid_index) set_hidden(face, is_hidden);
    }
  }
}

// Ends of passes ------------------------------------------------------------------------------------------------------

void ReplayIndexer::end_pass(const PassEnd& end) {
  undo_log_.passes.emplace_back();
  move(end);
  turn(end);
  if (is_any_hidden_ || !end.turned.empty()) list_corners();
  ++replay_.n_pass_ends_;
}

void ReplayIndexer::move(const PassEnd& end) {
  for (const auto& [vertex, position] : end.moved) {
    require(is_there(vertex), "a vertex that is moved isn't there");
    require(is_position(position), "a position isn't finite, or is above 3e150");
    undo_log_.passes.back().positions.push_back(std::exchange(replay_.positions_[vertex], position));
  }
}

void ReplayIndexer::turn(const PassEnd& end) {
  const auto is_not_before = [](const auto& a, const auto& b) { return a.face >= b.face; };
  require(std::adjacent_find(end.turned.begin(), end.turned.end(), is_not_before) == end.turned.end(),
          "the faces that get other corners are not ascending");
  for (const auto& [face, corners] : end.turned) {
    require(face < replay_.corners_.size() && replay_.has_face(face), "a face that gets other corners isn't there");
    require(has_three_corners(corners), "a face gets two equal corners");
    require(std::all_of(corners.begin(), corners.end(), [this](Index v) { return is_there(v); }),
            "a corner of a face isn't there");
    count_face(replay_.corners_[face], -1);
    undo_log_.passes.back().corners.push_back(std::exchange(replay_.corners_[face], corners));
    count_face(corners, 1);
  }
  if (end.turned.empty()) return;
  Replay::Counts& counts = replay_.counts_.back();
  const auto& before = undo_log_.passes.back().corners;
  const auto keep_faces = [this](const Triangle& corners) {
    return std::all_of(corners.begin(), corners.end(), [this](Index v) { return n_faces_at_[v] > 0; });
  };
  require(counts.n_vertices == n_vertices_ && std::all_of(before.begin(), before.end(), keep_faces),
          "faces that get other corners leave a vertex without a face");
}

}  // namespace whittle::progressive
