#pragma once

#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/progressive/replay.hh"

namespace whittle::progressive {

/// Whether the coordinates and their squares are finite.
inline bool is_position(const Vec3& p) {
  constexpr double most = 3e150;
  return (p.array().abs() <= most).all();
}

/// Does the steps of a replay once, from the input on, and builds the replay index: counts and undo log.
class ReplayIndexer {
 public:
  /// \param replay at level 0, with an empty index
  explicit ReplayIndexer(Replay& replay);

  /// \throw std::invalid_argument for an impossible step
  void run();

 private:
  void list_corners();
  void list_corner(Index corner);
  void contract(const Contraction& contraction);
  void move_corners(const Contraction& contraction);
  void hide_coincident(Index survivor);
  void show_first_ones(Index survivor);
  void set_hidden(Index face, bool is_hidden);
  void hide_as_without_backs();
  void end_pass(const PassEnd& end);
  void move(const PassEnd& end);
  void turn(const PassEnd& end);
  void count_face(const Triangle& face, int change);
  void check(const Contraction& contraction) const;
  void require(bool is_so, const char* what) const;
  bool is_there(Index vertex) const { return vertex < is_removed_.size() && !is_removed_[vertex]; }

  Replay& replay_;
  Replay::UndoLog& undo_log_;
  std::vector<bool> is_removed_;    ///< per vertex
  LargeArray<Index> first_, next_;  ///< first corner at each vertex; next corner after each corner
  LargeArray<Index> n_faces_at_;    ///< visible faces per vertex
  std::uint64_t n_vertices_ = 0;    ///< with faces
  std::uint64_t n_faces_ = 0;
  bool is_any_hidden_ = false;
  std::size_t n_followed_ = 0;  ///< visibility changes taken over from the replay without backs
};

}  // namespace whittle::progressive
