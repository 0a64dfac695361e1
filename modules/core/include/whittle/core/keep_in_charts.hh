#pragma once

#include <cstddef>
#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// The texture coordinates of a mesh made from another mesh: the first two of `n_components` numbers.
struct MovedTexture {
  const IndexedMesh& original;
  std::span<const double> original_values;  ///< n_components per wedge of the original
  std::span<const Index> wedge_map;         ///< per wedge of the original, its wedge in the mesh, or `invalid_index`
  std::size_t n_components;                 ///< 2 or more
  std::span<const Triangle> faces;          ///< of the mesh, as wedges
  std::span<const Index> maps = {};         ///< per wedge of the mesh, as `AttributeFunctions::maps`; or empty
  unsigned threads = 0;                     ///< 0 = all cores; the result is the same for any number
};

/// Moves texture coordinates of faces that lie over another chart of the original on the image, until they don't. Such
/// faces arise because a straight side cuts off the bays of a chart's border. The side's ends move towards the middle
/// of their neighbours, by the least amount. No face turns over on the image. Faces are tested at points, a hundredth
/// of their size inside.
/// - A face that is larger on the image than its chart stays as it is.
/// - A point over its own chart is right, even if another chart is there, too, as in a mirrored texture.
/// - Charts of other `face_groups` have other images. Charts of one map are one chart.
/// - Nothing moves if a number isn't finite.
/// \param values n_components per wedge of the mesh
/// \return number of faces that still lie over another chart
std::size_t keep_in_charts(const MovedTexture& texture, std::span<double> values);

}  // namespace whittle
