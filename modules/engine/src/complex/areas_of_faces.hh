#pragma once

#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// The areas (`seam_areas`) that are kept as long as there is anything else to contract.
struct AreasOfFaces {
  std::span<const Triangle> faces{};  ///< those that the stage begins with
  std::span<const Index> of{};        ///< of each face, `invalid_index` where there is none; or empty: there are none
  bool may_be_given_up = false;       ///< where nothing else is left to contract
};

}  // namespace whittle
