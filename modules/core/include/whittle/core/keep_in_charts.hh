#pragma once

#include <cstddef>
#include <span>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// The texture coordinates of a mesh that was made from another: the first two of `n_components` numbers.
struct MovedTexture {
  const IndexedMesh& original;
  std::span<const double> original_values;  ///< n_components for each wedge of the original
  std::span<const Index> wedge_map;  ///< of these, the wedge of the mesh that each has become; or `invalid_index`
  std::size_t n_components;          ///< 2 or more
  std::span<const Triangle> faces;   ///< of the mesh, as wedges
  unsigned threads = 0;              ///< 0 = all cores; the result is the same for any number
};

/// Moves texture coordinates of faces that lie over another chart of the original on the image, so that they show none
/// of it. A straight side cuts off the bays of a chart's border. Its ends are drawn towards the middle of their
/// neighbours, as little as will do. No face turns over on the image. Faces are looked at in points, a hundredth of
/// their size inside.
/// - A face that is larger on the image than its chart stays as it is.
/// - What lies over its own chart is right, whatever else is there, as where a texture is mirrored.
/// - Charts of other `face_groups` have other images.
/// - Nothing moves where a number isn't finite.
/// \param values n_components for each wedge of the mesh
/// \return how many faces still lie over another chart
std::size_t keep_in_charts(const MovedTexture& texture, std::span<double> values);

}  // namespace whittle
