#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fit/fit_weights.hh"
#include "guard/face_limits.hh"
#include "original/origins.hh"
#include "surface/line_samples.hh"
#include "surface/vertex_blocks.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/symmetric_matrix.hh"

namespace whittle::polishing {

/// Moves the vertices of a mesh to where its faces fit weighted points, each at its closest point (polish.hh).
class SurfaceFit {
 public:
  /// Keeps references to all. \param is_fixed per vertex, whether it may not move
  /// \throw Cancelled
  SurfaceFit(const Surface& mesh, const FaceNeighbors& neighbors, const FaceLimits& limits, const MeshLines& lines,
             const std::vector<std::uint8_t>& is_fixed, const detail::Workers& workers);

  /// Adds the points of the original. Uncovered faces are held in their planes. \throw Cancelled
  void add(const Origins& origins, const FitWeights& weights, const detail::Workers& workers);
  void add(const ClosestLinePoint& closest, double weight);
  /// Holds vertices back from sticking out. Keeps a reference to the offsets.
  /// \param offsets per vertex, from its closest point on the original to itself; zero: it is near
  /// \param most distance that few vertices should have
  void hold_back(std::span<const Vec3> offsets, double most);
  /// Draws vertices along the surface to the middle of their neighbours. \param weight over that of distances; 0: not
  void draw_to_middles(double weight) { shape_weight_ = weight; }
  /// The positions after two sweeps over the vertices. Each sweep moves vertices inside of blocks first.
  /// \param relaxation factor on the errors of points in faces: more than 1 makes the step longer
  /// \throw Cancelled
  std::vector<Vec3> moved(double relaxation, const detail::Workers& workers);

 private:
  /// Sums over the closest points in a face: of w b_j b_k, w b_j d, w d² and w.
  struct PointSums {
    std::array<double, 6> products{};  ///< 00, 01, 02, 11, 12, 22
    std::array<double, 3> errors{};
    double squares = 0;
    double weight = 0;

    void add(const ClosestFacePoint& closest, double point_weight);
    PointSums& operator+=(const PointSums& other);
  };
  /// A face before it was moved, and its sums. It fills two cache lines.
  struct alignas(64) Face : PointSums {
    Vec3 normal;  ///< of unit length, or zero
    double area;
    /// Squared cosine of the turn from which on the face may become a fold; more than 1: always.
    double wary_cosine_sq;

    double product(Index j, Index k) const {
      constexpr std::array<std::array<std::size_t, 3>, 3> index{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
      return products[index[j][k]];
    }
  };
  /// The same sums over the closest points on an edge; d is the vector perpendicular to it.
  struct LineSums {
    std::array<double, 3> products{};  ///< 00, 01, 11
    std::array<Vec3, 2> errors{Vec3::Zero(), Vec3::Zero()};
    double squares = 0;
    double weight = 0;
  };
  /// The least squares problem of one vertex, from its faces and lines.
  struct Pull {
    SymmetricMatrix matrix;
    Vec3 force = Vec3::Zero();
    double weight = 0;
    double squares = 0;
    SymmetricMatrix lines;  ///< Σ W P; P projects onto the plane perpendicular to a line
    double line_squares = 0;
    double along = 0;      ///< mean curvature of the surface part of the sum along the surface
    double area = 0;       ///< mean area of its faces
    bool is_held = false;  ///< whether it lies on lines without closest points
  };

  void measure_faces(const detail::Workers& workers);
  void hold_if_uncovered(Face& fit) const;
  void sweep(const detail::Workers& workers);
  void move_to_minimum(Index v);
  void prefetch_around(Index v) const;
  Pull pull_at(Index v) const;
  void add_lines(Index v, Pull& pull) const;
  void add_backward(Index v, Pull& pull) const;
  void add_shape(Index v, Pull& pull) const;
  Vec3 middle_around(Index v) const;
  Vec3 wanted_move(Index v, const Pull& pull) const;
  bool is_too_far(Index v, const Vec3& moved, const Pull& pull) const;
  bool spoils_a_face(Index v, const Vec3& to) const;
  bool turns_to_a_neighbor(Index face, Index v, const Vec3& to) const;
  Vec3 normal_with(Index face, Index v, const Vec3& to) const;

  Surface mesh_;  ///< before it is moved
  const FaceNeighbors& neighbors_;
  const FaceLimits& limits_;
  const MeshLines& lines_;
  const std::vector<std::uint8_t>& is_fixed_;
  VertexBlocks blocks_;
  LargeArray<Face> fits_;
  std::vector<std::uint8_t> is_inside_;  ///< per vertex, whether all its neighbours are in its block
  std::vector<LineSums> line_sums_;      ///< per edge of the lines
  std::vector<Vec3> ways_;               ///< per edge of the lines, from end to end, at the start
  double relaxation_ = 1;
  double shape_weight_ = 0;
  std::vector<Vec3> positions_;    ///< per vertex, now
  std::vector<Vec3> moves_;        ///< per vertex, since the start
  std::span<const Vec3> offsets_;  ///< per vertex, from its closest point on the original
  double most_backward_ = 0;       ///< length of an offset that few vertices should have
};

}  // namespace whittle::polishing
