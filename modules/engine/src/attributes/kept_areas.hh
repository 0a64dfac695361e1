#pragma once

#include <vector>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/engine/decimate_target.hh"

namespace whittle {

/// The areas of a mesh (`seam_areas`) of which a target keeps the last face.
class KeptAreas {
 public:
  KeptAreas() = default;
  /// \param areas of the mesh's faces, `invalid_index` where there is none; or empty
  KeptAreas(const IndexedMesh& mesh, const std::vector<Index>& areas);

  /// The area of each face, `invalid_index` where it isn't kept; or empty, if there are none. A target keeps the
  /// largest areas, so many that each could have a few of the faces: in a mesh of many small charts they would take the
  /// faces from the shape else. Without a number as target all are kept.
  std::vector<Index> of(const DecimateTarget& target) const;

 private:
  std::vector<Index> ranks_;  ///< of each face that of its area by size, from 0, the largest
};

}  // namespace whittle
