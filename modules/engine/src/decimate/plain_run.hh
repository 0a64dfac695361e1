#pragma once

#include <vector>

#include "decimate/staged_run.hh"
#include "error/error_bounds.hh"

namespace whittle {

/// A run that goes on without a limit of the error, down to the last face, and its levels: the first k of its
/// contractions make one. Of each it can be asked whether it is proven to be near to the input.
class PlainRun {
 public:
  /// Runs on. Afterwards the run is as it was. Both must outlive it.
  /// \param run with a limit of the error
  PlainRun(StagedRun& run, ErrorBounds& bounds, const BlockPlan& plan);

  /// \pre the run was not cancelled
  bool is_proven_with_vertices(std::size_t n_vertices);

  /// Looks for a level of few faces that is proven, by bisection, to 1 % of its faces. Levels of more than `most_faces`
  /// are of no use: they count as proven, as do those before one that is. \return whether there is one. Then the run
  /// has contracted to it, or is cancelled
  bool contract_to_coarsest_proven(std::size_t most_faces, const BlockPlan& plan);

 private:
  struct Level {
    IndexedMesh mesh;               ///< over the input's vertices
    std::vector<Index> vertex_map;  ///< the input's vertices → those that they have become
  };
  Level start_level() const;
  Level level_after(std::size_t n_contractions) const;
  CheckedSurface checked(const Level& level) const;
  void contract(const DecimateTarget& stop, const BlockPlan& plan);

  StagedRun& run_;
  ErrorBounds& bounds_;
  StagedRun::State start_;
  std::vector<Contraction> contractions_;
  std::size_t n_vertices_left_ = 0;  ///< at the end
  std::size_t proven_ = 0;           ///< contractions of a level that was asked for and is proven; 0 for none
};

}  // namespace whittle
