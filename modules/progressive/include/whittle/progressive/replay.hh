#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/run_steps.hh"

// Levels of detail out of the steps of a run. A step contracts a pair, or is a pass of polish, and can be done and
// undone. Level k is the surface after k steps: level 0 is the input, the last one the run's result.
// \cite hoppe_1996_progressive

namespace whittle::progressive {

/// The surface at any level. A replay goes from level to level by a replay index: counts and an undo log, by step.
class Replay {
 public:
  /// A step hides a face that coincides with others, or shows it again.
  struct VisibilityChange {
    std::size_t step;
    Index face;
    bool is_hidden;
  };

  /// Goes through all steps once to build the replay index. Ends at the last level.
  /// \param normals as in the options of the run
  /// \throw std::invalid_argument for steps that are impossible on this mesh, or a mesh that `decimate` rejects
  /// \throw std::length_error for 2³² / 3 faces or more
  Replay(IndexedMesh input, RunSteps steps, Normals normals = Normals::keep);

  const IndexedMesh& input() const { return input_; }
  const RunSteps& steps() const { return steps_; }
  /// By step, ascending.
  std::span<const VisibilityChange> visibility_changes() const { return undo_log_.visibility; }
  std::uint64_t n_faces_after(std::size_t n_contractions) const { return counts_of(n_contractions).n_faces; }
  std::size_t n_steps() const { return steps_.contractions.size() + steps_.pass_ends.size(); }

  // Levels ------------------------------------------------------------------------------------------------------------

  // Each function returns the last level with its count, after a pass of polish that follows the contraction.

  /// The first level with at most `n_faces` faces; empty if the last level has more.
  std::optional<std::size_t> level_of_faces(std::uint64_t n_faces) const;
  /// The first level with at most `n_vertices` vertices; empty if the last level has more.
  std::optional<std::size_t> level_of_vertices(std::uint64_t n_vertices) const;
  /// The last level without a contraction that costs more than `cost`. \param cost unit as `DecimateTarget::max_cost`
  std::size_t level_of_cost(double cost) const;
  /// The level after a share of the contractions, rounded. \param share [0, 1], clamped
  std::size_t level_at(double share) const;
  /// The level after `n_contractions`, or all if there are fewer.
  std::size_t level_after(std::size_t n_contractions) const;

  // The surface at the current level ----------------------------------------------------------------------------------

  /// Takes time in proportion to the steps between. \throw std::out_of_range if `level` > `n_steps()`
  void go_to(std::size_t level);
  std::size_t level() const { return n_contractions_ + n_pass_ends_; }
  std::size_t n_contractions() const { return n_contractions_; }
  std::uint64_t n_vertices() const { return counts_of(n_contractions_).n_vertices; }  ///< vertices with a face
  std::uint64_t n_faces() const { return counts_of(n_contractions_).n_faces; }
  /// The largest cost of a contraction so far.
  double cost() const { return n_contractions_ == 0 ? 0 : counts_of(n_contractions_).cost; }

  /// \param face of the input. Only meaningful if `has_face`
  const Triangle& corners(Index face) const { return corners_[face]; }
  bool has_face(Index face) const { return is_hidden_[face] == 0 && has_three_corners(corners_[face]); }
  /// \param vertex of the input. Only meaningful if it has a face
  const Vec3& position(Index vertex) const { return positions_[vertex]; }

  /// The output of `decimate` at this level. `result` has only the counts and the cost; there are no feature edges.
  /// Takes time in proportion to the input.
  Decimation decimation() const;

  /// For each vertex of the input, its survivor at this level, with or without faces.
  std::vector<Index> survivors() const;

 private:
  friend class ReplayIndexer;

  /// After a contraction.
  struct Counts {
    double cost;  ///< largest so far
    Index n_vertices, n_faces;
  };
  /// State before a pass of polish.
  struct PassBefore {
    std::vector<Vec3> positions;    ///< of the moved vertices
    std::vector<Triangle> corners;  ///< of the turned faces
  };
  /// What each step replaced.
  struct UndoLog {
    LargeArray<Index> corners;  ///< corners, 3 a face, that go from removed vertex to survivor, by contraction
    LargeArray<std::size_t> first_corner;  ///< per contraction, its first entry in `corners`; then the end
    LargeArray<Vec3> positions;            ///< per contraction, the survivor's position before
    std::vector<PassBefore> passes;
    std::vector<VisibilityChange> visibility;  ///< by step, ascending

    std::span<const Index> corners_of(std::size_t contraction) const {
      return std::span(corners).subspan(first_corner[contraction],
                                        first_corner[contraction + 1] - first_corner[contraction]);
    }
  };

  const Counts& counts_of(std::size_t n_contractions) const { return counts_[n_contractions]; }
  void contract();
  void undo_contraction();
  void end_pass();
  void undo_pass_end();
  bool is_pass_end_next() const {
    return n_pass_ends_ < steps_.pass_ends.size() && steps_.pass_ends[n_pass_ends_].n_contractions == n_contractions_;
  }
  bool is_pass_end_last() const {
    return n_pass_ends_ > 0 && steps_.pass_ends[n_pass_ends_ - 1].n_contractions == n_contractions_;
  }
  void apply_visibility();
  void undo_visibility();
  std::vector<Index> faces_left() const;
  void add_attributes(const std::vector<Index>& numbers, Decimation& out) const;
  void carry_attributes_to(const std::vector<Index>& numbers, Decimation& out) const;

  /// A replay of the same steps without the backs of two-sided sheets.
  struct WithoutBacks;
  static std::shared_ptr<WithoutBacks> make_without_backs(const IndexedMesh& input, const RunSteps& steps,
                                                          Normals normals);
  Decimation decimation_with_backs() const;

  IndexedMesh input_;
  RunSteps steps_;
  Normals normals_;
  std::shared_ptr<WithoutBacks> without_backs_;  ///< null without sheets

  // The replay index.
  LargeArray<Counts> counts_;  ///< by number of contractions done
  UndoLog undo_log_;

  // The current level.
  LargeArray<Vec3> positions_;
  LargeArray<Triangle> corners_;
  std::vector<std::uint8_t> is_hidden_;
  std::size_t n_contractions_ = 0;
  std::size_t n_pass_ends_ = 0;
  std::size_t n_visibility_changes_ = 0;
};

/// The levels of a curve: the number of faces falls by a quarter from one to the next. The first is the input, the last
/// the result. \return ascending
std::vector<std::size_t> levels_of_curve(const Replay& replay);

}  // namespace whittle::progressive
