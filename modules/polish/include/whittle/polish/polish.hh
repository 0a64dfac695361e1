#pragma once

#include <cstdint>
#include <span>

#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/vertex_pair.hh"

// Polish: moves the vertices of a simplified mesh to where its faces fit the original surface best. Per pass
//
//   each point s of the original gets a foot: of those faces at the vertex that it became, or that a corner of its face
//     did, which face the same way and hold the foot of the perpendicular, the nearest one; the barycentric coordinates
//     b there, and d, the distance from the face's plane
//   the vertices, each in its turn and twice, move to where Σ w (d − n · Σ b_j x_j)² + μ Σ W |x|² is least, x how far
//     they have moved, n the face's normal, w the area a point stands for over 1 + |d| / e, e the root of the mean
//     square distance between the surfaces: near points count by squares, far ones by distance (Fair's weights,
//     \cite holland_1977_robust)
//
// The points are the original's vertices, with a quarter of the weight, and the centroids of its faces, or four points
// in each if the simplified mesh has nearly as many. Borders and feature lines are fitted to the original's in the same
// way: points on its edges have feet on edges of the simplified mesh, d is the vector to them across the edge, and the
// sum of their squares is added, as if the line were a strip of surface.
//
// A vertex moves less far, or not at all, where that would turn a face over, or fold two neighbours (bring their
// normals more than 120° apart, and further than they were; where both were less than 90° apart and neither has turned
// by 26°, this isn't looked at, and they end below 142°), or take it from the planes of its own faces, or from its
// lines, by more than the surface or the lines are off there anyway (corners stay corners), or from where it was by a
// seventh of an edge. Then moves are taken back at vertices whose lines have come to be further from the original's
// than these were anywhere, and around faces that have come to intersect others. In the end the distances between the
// surfaces, both ways, tell whether a pass helped, by what Fair's weights make least; if not, it is taken back.

namespace whittle {

struct PolishOptions {
  unsigned passes = 1;                     ///< how often feet are found and vertices moved. 0 = nothing happens
  std::span<const std::uint8_t> locked{};  ///< V of the simplified mesh or empty; vertices with a non-zero entry stay
  /// Whether edges are flipped, too, before vertices are moved: where that lessens the sum of the squared distances of
  /// the points that have their feet in an edge's two faces, makes no folds, intersections or vertices with fewer than
  /// four or more than nine faces, and the edge is on no line nor between two groups of faces. Both faces keep their
  /// numbers. A mesh with texture coordinates keeps its edges.
  bool flips = false;
  bool fit_borders = true;  ///< whether border vertices move

  /// Edges of two faces whose normals differ by more than this are sharp, degrees. (0, 180]; 180 = none. Features stay
  /// sharp, and no other edges get so.
  double feature_angle_deg = 180;
  std::span<const VertexPair> features{};           ///< of the simplified mesh, as `Decimation::feature_edges`
  std::span<const VertexPair> original_features{};  ///< what these were made from: `feature_edges` of the original
  /// No face gets a smaller radius ratio (radius_ratio.hh) than this, or 0.001, unless it had a smaller one. [0, 1].
  double min_radius_ratio = 0;
  unsigned threads = 0;  ///< 0 = all cores; the result is the same
};

struct PolishResult {
  std::uint64_t n_moved = 0;  ///< vertices that are not where they were
  unsigned n_passes = 0;      ///< that helped; one that doesn't is taken back, and is the last
  double rms_before = 0;      ///< distance between the surfaces, both ways, at some points of each; model units
  double rms_after = 0;
};

/// Moves vertices of `mesh`, and computes its normals anew if it has some; nothing else of it changes but what `flips`
/// says. Vertices stay where it isn't manifold, and where lines meet or end.
/// \param original what `mesh` was made from; all positions finite. Nothing happens if either has no faces
/// \param vertex_map vertices of `original` → a vertex of `mesh` near it on the surface, as
///        `Decimation::vertex_map` is; `invalid_index` for none: these don't count
/// \throw std::invalid_argument if `vertex_map` or `locked` has a wrong length, or a number or the angle is out of
/// range
PolishResult polish(const IndexedMesh& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options = {});

}  // namespace whittle
