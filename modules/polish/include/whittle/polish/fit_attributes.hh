#pragma once

#include <cstddef>
#include <span>

#include "whittle/core/indexed_mesh.hh"

// Attributes of a simplified mesh, fitted to those of its original:
//
//   minimise  Σ_s m_s |Σ_k b_sk x_sk − a_s|²  +  λ Σ_w M_w |x_w − x⁰_w|²
//
//   - s is a point of the original, one of those that polish looks at (polish.hh), m_s its weight, a_s its value
//   - b_sk are the barycentric coordinates of its foot on the simplified mesh, x_sk the values of the corners there
//   - x⁰_w is the value that the original has nearest to wedge w, M_w = Σ m_s b_sk, and λ is 0.02
//
// Texture coordinates are moved, where the fit leaves a fold, as little as takes it away: a fold is a face that lies on
// the image the other way round than the original does there. Then they are kept in their charts (keep_in_charts.hh).
//
// Feet are found on the same side of every seam: both surfaces are cut open there. The normal equations are solved by
// conjugate gradients, for each number of a value by itself.

namespace whittle {

struct FitAttributesOptions {
  bool fit_normals = true;  ///< whether normals are fitted, too
  unsigned threads = 0;     ///< 0 = all cores; the result is the same for any number
};

struct AttributeFitReport {
  std::size_t n_folded_faces = 0;  ///< that are left, of all sets of texture coordinates
};

/// Fits the attributes of `mesh`: texture coordinates, colours, normals and whatever else may be blended. Normals and
/// tangents keep unit length, colours stay in [0, 1]. Categories, joint weights, and attributes with a value that isn't
/// finite become those of the original's nearest point. Nothing happens if either mesh has no faces.
/// \param original what `mesh` was made from
/// \param wedge_map for each wedge of `original` that of `mesh` that it has become, or `invalid_index`
/// \param mesh has the attributes of the original, in the same order
/// \throw std::invalid_argument for a map of another length than the wedges, or for wedges that aren't there
AttributeFitReport fit_attributes(const IndexedMesh& original, std::span<const Index> wedge_map, IndexedMesh& mesh,
                                  const FitAttributesOptions& options = {});

}  // namespace whittle
