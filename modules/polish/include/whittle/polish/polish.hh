#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/core/progress.hh"
#include "whittle/core/vertex_pair.hh"

// Polish moves the vertices of a simplified mesh to where its faces fit the original surface best. Each pass does this:
//
//   find the closest point of each point s of the original. Candidates are the faces at the vertex that s (or a corner
//     of its face) was merged into, if they face the same way as s and the perpendicular from s meets them. The
//     closest point has barycentric coordinates b; s has the signed distance d from the plane of its face
//   find the closest point on the original of each vertex of the mesh that sticks out
//   twice, move each vertex in turn to the minimum of Σ w (1.5 d − n · Σ b_j x_j)² + μ |x|² + W (h / 5.5 e)⁸
//   - x_j is how far corner j of the face has moved, and n is the face's normal
//   - w is the area that the point represents over 1 + |d| / e, where e is the root mean square distance between the
//     surfaces. These are Fair's weights: near points count by their squared distance, far ones by their distance.
//     \cite holland_1977_robust
//   - μ is a hundredth of the curvature that the sum has along the surface
//   - with a weight S for shape, S / 1000 Σ w |x − m|² is added, along the surface; m is the way to the middle of the
//     vertex' neighbours: on a line, of those along it
//   - h is the vertex' distance from the original, and W a hundredth of the weight of the points around
//   - uncovered faces, which have few closest points, are held in their planes
//
// The points are the original's vertices, which carry a quarter of the weight, and the centroids of its faces. Where
// the simplified mesh has nearly as many faces as the original, each face has four points instead of its centroid.
//
// Borders, feature lines and seams are fitted to those of the original in the same way. Points on the original's lines
// have their closest points on edges of the simplified mesh, and d is the vector from there, perpendicular to the edge.
// Their sum of squares is added as if the line were a strip of surface.
//
// A vertex moves a shorter way, or not at all, where the full move would
//   - turn a face over;
//   - fold two neighbouring faces: bring their normals more than 120° apart, and further apart than before. This is not
//     checked at faces that have turned by less than 26° and whose neighbours were less than 90° apart; these stay
//     below 142°;
//   - take the vertex further from the planes of its faces, or from its lines, than the surface or the lines are off
//     there anyway (so corners stay corners);
//   - take the vertex further than a seventh of an edge.
// Then three kinds of moves are undone: moves that let a line drift further from the original's than any line was
// before, moves that let a vertex drift further than 5.5 e from the original, and moves around faces that newly
// intersect others. In the end a pass is kept only if it lowers the distance between the surfaces, measured both ways
// with the same weights; else it is tried once more with 1 instead of 1.5.

namespace whittle {

namespace polishing {
class OriginalSurface;
}

/// The distance between the surfaces that polish reduces.
enum class Fit {
  mean,      ///< the mean
  balanced,  ///< the mean, and vertices are held back from sticking out of the original
  max        ///< the largest: vertices are held back more, and points of the original that are far off count for more
};

struct PolishOptions {
  /// Largest number of passes; 0 = off. A pass that doesn't reduce the error is undone, and is the last.
  unsigned passes = 1;
  Fit fit = Fit::balanced;
  std::vector<std::uint8_t> locked{};  ///< V of the simplified mesh, or empty; vertices with a non-zero entry stay
  /// Whether each pass also flips edges, before it moves vertices. An edge is flipped where that lowers the sum of the
  /// squared distances of the points whose closest points are in its two faces. A flip makes no folds, no
  /// intersections, and no vertex with fewer than four or more than nine faces. Edges of lines stay, and edges between
  /// two regions. Faces keep their numbers. The edges of a mesh with a table of wedges stay.
  bool flips = false;
  /// F of the simplified mesh: numbers of its regions. Empty: those of `face_regions`.
  std::vector<Index> regions{};
  bool fit_borders = true;  ///< whether border vertices move

  /// An edge is sharp where the normals of its two faces differ by more than this, degrees. (0, 180); none = no edge is
  /// sharp. Features stay sharp, and no other edge becomes sharp.
  std::optional<double> feature_angle_deg{};
  std::vector<VertexPair> features{};           ///< edges of the simplified mesh, as `Decimation::feature_edges`
  std::vector<VertexPair> original_features{};  ///< edges of the original, as `feature_edges` finds them
  /// Largest distance of features from the original's features, model units. [0, inf]. Features beyond it don't get
  /// further off.
  double feature_tolerance = std::numeric_limits<double>::infinity();
  /// Borders of charts and regions, as `seam_edges` finds them. They stay near those of the original, whatever their
  /// angle is or becomes. An edge that is a feature, too, counts as a feature.
  std::vector<VertexPair> seams{};           ///< edges of the simplified mesh
  std::vector<VertexPair> original_seams{};  ///< edges of the original
  /// Weight of seams in the fit, over that of borders. (0, inf). With a weight, far seams count for less, by Fair's
  /// weights, and vertices where seams meet move. None: seams count as borders do, and vertices where seams meet or end
  /// stay.
  std::optional<double> seam_weight{};
  /// Smallest radius ratio (radius_ratio.hh) that a face may get. A face that had a smaller one may keep it. [0, 1];
  /// less than 0.001, or none, counts as 0.001.
  std::optional<double> min_radius_ratio{};
  /// Weight of round triangles and even valences against the distance. [0, inf); 0 = off. With a weight, a vertex is
  /// drawn along the surface to the middle of its neighbours, and no flip makes its two faces less round, or valences
  /// less regular (as valence_term.hh of the engine has it).
  double shape_weight = 0;
  bool recompute_normals = true;  ///< whether to compute vertex normals anew from the faces, if the mesh has some
  double crease_angle_deg =
      default_crease_angle_deg;  ///< at edges with a larger angle normals break, degrees. (0, 180]
  unsigned threads = 0;          ///< 0 = all cores; the result is the same for any number
  /// Cancelling leaves the mesh as it was after the last pass that helped, or unchanged.
  ProgressCallback progress{};
};

struct PolishResult {
  std::uint64_t n_moved = 0;  ///< number of vertices with a new position
  unsigned n_passes = 0;      ///< number of passes that reduced the error
  double rms_before = 0;      ///< root mean square distance between the surfaces, both ways, sampled; model units
  double rms_after = 0;       ///< the same, afterwards
  bool cancelled = false;     ///< whether `progress` ended the run. Cancelled before the first pass, both rms may be 0
};

/// The original, prepared for `polish`. Make it once for several calls with one original.
class PolishOriginal {
 public:
  /// Keeps a reference to the mesh: positions finite.
  /// \param threads 0 = all cores
  /// \param progress is asked, but sees no progress yet
  /// \throw std::invalid_argument if a face names a missing vertex; Cancelled
  explicit PolishOriginal(const IndexedMesh& mesh, unsigned threads = 0, const ProgressCallback& progress = {});
  ~PolishOriginal();
  PolishOriginal(PolishOriginal&& other) noexcept;
  PolishOriginal& operator=(PolishOriginal&& other) noexcept;

  const polishing::OriginalSurface& surface() const { return *surface_; }

 private:
  std::unique_ptr<const polishing::OriginalSurface> surface_;
};

/// Moves vertices of `mesh`. Nothing else changes, except what `PolishOptions::flips` and `recompute_normals` describe.
/// Vertices where the mesh is not manifold stay, and those where lines meet or end.
/// Nothing happens if either mesh has no faces, or if `mesh` is a million times as far away as the original is large.
/// \param original the mesh that `mesh` was made from; all positions finite
/// \param vertex_map for each vertex of `original` a vertex of `mesh` near it on the surface, as
///        `Decimation::vertex_map` has them; vertices with `invalid_index` are ignored
/// \throw std::invalid_argument if a face, feature or seam names a missing vertex, `vertex_map`, `locked` or `regions`
///        has a wrong length, or an option is out of range
PolishResult polish(const PolishOriginal& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options = {});
PolishResult polish(const IndexedMesh& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options = {});

}  // namespace whittle
