#pragma once

#include <cstddef>
#include <span>

#include "whittle/core/indexed_mesh.hh"

// Attributes of a simplified mesh, fitted to those of its original:
//
//   minimise  Σ_s m_s |Σ_k b_sk x_sk − a_s|²  +  λ Σ_w M_w |x_w − x⁰_w|²
//
//   - s is a point that represents the original, as in polish.hh, m_s its weight, a_s its value
//   - b_sk are the barycentric coordinates of its closest point on the simplified mesh, x_sk the values of the corners
//   - x⁰_w is the original's value nearest to wedge w, M_w = Σ m_s b_sk, and λ is 0.02
//
// A number that is linear in the position throughout its chart keeps that function instead (attribute_functions.hh).
//
// Where the fit leaves a fold, texture coordinates are moved by the least amount that removes it. A fold is a face
// whose orientation on the image differs from the original's there. Then coordinates are kept in their charts
// (keep_in_charts.hh).
//
// Closest points are found on the same side of every seam: both surfaces are cut open there. The normal equations are
// solved by conjugate gradients, for each component of a value by itself.

namespace whittle {

struct FitAttributesOptions {
  bool fit_normals = true;  ///< whether to fit normals, too
  unsigned threads = 0;     ///< 0 = all cores; the result is the same for any number
};

struct AttributeFitReport {
  std::size_t n_folded_faces = 0;  ///< number of folds left, in all sets of texture coordinates
};

/// Fits the attributes of `mesh`: texture coordinates, colours, normals and all others that can be blended. Normals and
/// tangents keep unit length, colours stay in [0, 1]. Categories, joint weights, and attributes with a value that isn't
/// finite are copied from the closest point of the original. Nothing happens if either mesh has no faces.
/// \param original the mesh that `mesh` was made from
/// \param wedge_map for each wedge of `original` its wedge in `mesh`, or `invalid_index`
/// \param mesh has the attributes of the original, in the same order
/// \throw std::invalid_argument if the map's length differs from the number of wedges, or names a missing wedge
AttributeFitReport fit_attributes(const IndexedMesh& original, std::span<const Index> wedge_map, IndexedMesh& mesh,
                                  const FitAttributesOptions& options = {});

}  // namespace whittle
