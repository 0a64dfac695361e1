#pragma once

#include <span>
#include <vector>

#include "cost/attributes/surface_attributes.hh"
#include "whittle/core/detail/index_lists.hh"

namespace whittle {

/// The attributes of the input. Wedges are summed up over its faces where they are asked for: for all of a large mesh
/// at once they would take more memory than the mesh.
class InputAttributes {
 public:
  /// Keeps a reference to the input.
  InputAttributes(const IndexedMesh& input, const Frame& frame, ScaledAttributes attributes);

  /// Those of some vertices, which get their places as numbers. Wedges without faces are left out.
  /// \param vertices ascending
  SurfaceAttributes at(std::span<const Index> vertices, unsigned threads) const;
  SurfaceAttributes all(unsigned threads) const;

 private:
  void sum_up(Index wedge, Index vertex, Index place, std::vector<WedgeFace>& faces, WedgeQuadrics& sums) const;
  const double* values(Index wedge) const { return attributes_.values.data() + wedge * attributes_.stride(); }

  const IndexedMesh& input_;
  Frame frame_;
  ScaledAttributes attributes_;
  detail::IndexLists<Index> wedges_at_;              ///< by vertex; none if each is a wedge
  detail::IndexLists<Index, std::size_t> faces_of_;  ///< by wedge
};

}  // namespace whittle
