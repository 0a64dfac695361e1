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

/// The surface at any of its levels, and the way between them.
class Replay {
 public:
  /// A face that is there no more because it coincides with others, or is there again.
  struct Hiding {
    std::size_t step;
    Index face;
    bool is_hidden;
  };

  /// Goes through all steps once, to find out what undoes them. It ends at the last level.
  /// \param normals what the run did with them
  /// \throw std::invalid_argument for steps that no run makes of this mesh, or a mesh that `decimate` rejects
  /// \throw std::length_error for 2³² / 3 faces or more
  Replay(IndexedMesh input, RunSteps steps, Normals normals = Normals::keep);

  const IndexedMesh& input() const { return input_; }
  const RunSteps& steps() const { return steps_; }
  /// By step, ascending.
  std::span<const Hiding> hidings() const { return hidings_; }
  std::uint64_t n_faces_after(std::size_t n_contractions) const { return counts_of(n_contractions).n_faces; }
  std::size_t n_steps() const { return steps_.contractions.size() + steps_.pass_ends.size(); }

  // Which level
  // --------------------------------------------------------------------------------------------------------- Each of
  // these is the last level with its count: a pass of polish that came right after the contraction is done, too.

  /// The first level of so few faces; empty if the last one has more.
  std::optional<std::size_t> level_of_faces(std::uint64_t n_faces) const;
  std::optional<std::size_t> level_of_vertices(std::uint64_t n_vertices) const;
  /// The last level to which no contraction costs more. \param cost unit as `DecimateTarget::max_cost`
  std::size_t level_of_cost(double cost) const;
  /// The level after this share of the contractions, rounded. \param share [0, 1]
  std::size_t level_at(double share) const;
  /// The level after so many contractions, at most all.
  std::size_t level_after(std::size_t n_contractions) const;

  // The surface at the current level
  // ------------------------------------------------------------------------------------

  /// Takes time in proportion to the steps between.
  void go_to(std::size_t level);
  std::size_t level() const { return n_contractions_ + n_pass_ends_; }
  std::size_t n_contractions() const { return n_contractions_; }
  std::uint64_t n_vertices() const { return counts_of(n_contractions_).n_vertices; }  ///< that have a face
  std::uint64_t n_faces() const { return counts_of(n_contractions_).n_faces; }
  /// The greatest cost of a contraction so far.
  double cost() const { return n_contractions_ == 0 ? 0 : counts_of(n_contractions_).cost; }

  /// \param face of the input. Meaningful while it is there
  const Triangle& corners(Index face) const { return corners_[face]; }
  bool has_face(Index face) const { return is_hidden_[face] == 0 && has_three_corners(corners_[face]); }
  /// \param vertex of the input. Meaningful while it is there
  const Vec3& position(Index vertex) const { return positions_[vertex]; }

  /// As `decimate` to this level gives it. `result` has the counts and the cost alone, and there are no feature edges.
  /// Takes time in proportion to the input.
  Decimation decimation() const;

  /// For each vertex of the input, the vertex of the input that stands for it now; also if that one has no face.
  std::vector<Index> survivors() const;

 private:
  friend class Rehearsal;

  /// After a contraction.
  struct Counts {
    double cost;  ///< the greatest so far
    Index n_vertices, n_faces;
  };
  /// What undoes a pass of polish.
  struct PassBefore {
    std::vector<Vec3> positions;
    std::vector<Triangle> corners;
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
  std::span<const Index> renamed(std::size_t contraction) const {
    return std::span(renamed_).subspan(first_renamed_[contraction],
                                       first_renamed_[contraction + 1] - first_renamed_[contraction]);
  }
  void hide();
  void undo_hiding();
  std::vector<Index> faces_left() const;
  void add_attributes(const std::vector<Index>& numbers, Decimation& out) const;
  void carry_attributes_to(const std::vector<Index>& numbers, Decimation& out) const;

  /// The same without the backs of two-sided sheets.
  struct WithoutBacks;
  static std::shared_ptr<WithoutBacks> make_without_backs(const IndexedMesh& input, const RunSteps& steps,
                                                          Normals normals);
  Decimation decimation_with_backs() const;

  IndexedMesh input_;
  RunSteps steps_;
  Normals normals_;
  std::shared_ptr<WithoutBacks> without_backs_;  ///< none if there are no sheets

  // What the rehearsal has found out.
  LargeArray<Counts> counts_;              ///< by number of contractions done
  LargeArray<Index> renamed_;              ///< corners, 3 a face, that get the survivor's number, by contraction
  LargeArray<std::size_t> first_renamed_;  ///< of each contraction, and the end
  LargeArray<Vec3> before_;                ///< where the survivor of each contraction was
  std::vector<PassBefore> passes_before_;
  std::vector<Hiding> hidings_;  ///< by step, ascending

  // The current level.
  LargeArray<Vec3> positions_;
  LargeArray<Triangle> corners_;
  std::vector<std::uint8_t> is_hidden_;
  std::size_t n_contractions_ = 0;
  std::size_t n_pass_ends_ = 0;
  std::size_t n_hidings_ = 0;
};

}  // namespace whittle::progressive
