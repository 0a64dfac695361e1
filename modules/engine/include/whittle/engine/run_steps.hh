#pragma once

#include <cstdint>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// One contraction, in the input's vertex numbers.
struct Contraction {
  Index survivor;
  Index removed;
  Vec3 position;           ///< of the survivor from now on, model units
  double cost;             ///< unit as `DecimateTarget::max_cost`
  bool is_threshold_pair;  ///< whether the two were a pair beside the edges
  /// Whether faces of the two coincide now. Of those over each edge, one of the more frequent orientation is left; none
  /// if both are equally frequent.
  bool joins_faces;
};

/// What a run did to the surface between two series of contractions.
struct PassEnd {
  struct MovedVertex {
    Index vertex;   ///< of the input
    Vec3 position;  ///< model units
  };
  struct TurnedFace {
    Index face;        ///< of the input
    Triangle corners;  ///< vertices of the input
  };
  std::uint64_t n_contractions = 0;  ///< made before
  std::vector<MovedVertex> moved;    ///< at a checkpoint or by the fit in the end, ascending
  std::vector<TurnedFace> turned;    ///< faces at edges that these flipped, ascending
};

/// All that a run did, in order: enough to do it again.
struct RunSteps {
  std::vector<Contraction> contractions;
  /// Of those faces that coincide, the first is left, from then on.
  std::vector<PassEnd> pass_ends;
  bool fits_attributes = false;   ///< whether attributes are fitted to the input's in the end (`fit_attributes`)
  double crease_angle_deg = 180;  ///< where normals break that are computed anew (`DecimateOptions::crease_angle_deg`)
};

}  // namespace whittle
