#pragma once

#include <array>
#include <cstddef>
#include <map>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// Numbers of edges at inner vertices, which have faces and no boundary edge.
struct ValenceStats {
  std::size_t vertices = 0;                      ///< Inner vertices; if 0, all other fields are 0.
  std::size_t min = 0;                           ///< Smallest valence.
  std::size_t max = 0;                           ///< Largest valence.
  double share_5_to_7 = 0.0;                     ///< Share of valences 5, 6 and 7, in [0, 1].
  std::map<std::size_t, std::size_t> histogram;  ///< Valence to number of vertices, no zeros.
};

/// The quality of the triangles of a mesh.
struct Shape {
  /// Twice the radius of the inscribed circle over the radius of the circumscribed circle, 2r/R, in [0, 1]; equilateral
  /// 1, degenerate 0.
  double radius_ratio_mean = 0.0;
  double radius_ratio_min = 0.0;
  /// Numbers of faces by radius ratio, in equal parts of [0, 1]; the last one includes 1.
  std::array<std::size_t, 20> radius_ratio_histogram{};
  /// The least angle of each face, in [0, 60].
  double min_angle_mean_deg = 0.0;
  double min_angle_min_deg = 0.0;
  /// Faces with a radius ratio below 1e-6, collapsed ones (the same vertex twice) included.
  std::size_t degenerate_faces = 0;

  ValenceStats valence;
  double edge_length_mean = 0.0;  ///< Model units.
  double edge_length_cv = 0.0;    ///< Standard deviation of the edge lengths over their mean.
  /// Edges with two faces nearly folded onto each other: the cosine between their normals is below −0.94. If both faces
  /// run along the edge in the same direction, one of them is reversed first.
  std::size_t folds = 0;
};

/// O(F) time. Means give all faces, edges or inner vertices the same weight.
/// \throw std::invalid_argument as `bounds`.
Shape shape(const IndexedMesh& mesh);

}  // namespace whittle::metrics
