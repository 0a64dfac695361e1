#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "guard/face_limits.hh"
#include "surface/foot_finder.hh"
#include "surface/line_samples.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/vertex_corners.hh"
#include "whittle/core/geometry/symmetric_matrix.hh"

namespace whittle {

/// Moves the vertices of a mesh to where its faces fit weighted points, each at its foot (polish.hh).
class SurfaceFit {
 public:
  /// Keeps references to all. \param is_fixed per vertex, whether it stays
  SurfaceFit(const std::vector<Triangle>& faces, const VertexCorners& corners, const FaceNeighbors& neighbors,
             const FaceLimits& limits, const MeshLines& lines, const std::vector<std::uint8_t>& is_fixed);

  /// Takes where the vertices are, and forgets all points.
  void start(std::vector<Vec3>& positions);
  void add(const Foot& foot, double weight);
  void add(const LineFoot& foot, double weight);
  /// Moves each vertex in its turn, by number.
  void sweep();

 private:
  /// A face before it was moved, and sums over the feet in it: of w b_j b_k, w b_j d, w d² and w. Two cache lines.
  struct alignas(64) Face {
    Vec3 normal = Vec3::Zero();  ///< of unit length, or zero
    double area = 0;
    double wary_cosine_sq = 0;         ///< of the cosine to the normal below which it may fold
    std::array<double, 6> products{};  ///< 00, 01, 02, 11, 12, 22
    std::array<double, 3> errors{};
    double squares = 0;
    double weight = 0;

    double product(Index j, Index k) const {
      constexpr std::array<std::array<std::size_t, 3>, 3> place{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
      return products[place[j][k]];
    }
  };
  /// Likewise over the feet on an edge, d the vector across it.
  struct LineSums {
    std::array<double, 3> products{};  ///< 00, 01, 11
    std::array<Vec3, 2> errors{Vec3::Zero(), Vec3::Zero()};
    double squares = 0;
    double weight = 0;
  };
  /// What the faces and lines at a vertex want of it.
  struct Pull {
    SymmetricMatrix matrix;
    Vec3 force = Vec3::Zero();
    double weight = 0;
    double squares = 0;
    SymmetricMatrix lines;  ///< Σ W P, P the projection across a line
    double line_squares = 0;
    double area = 0;       ///< of a face, on average
    bool is_held = false;  ///< whether it is on a line of which no point has its foot here
  };

  void measure_faces();
  void prefetch_around(Index v) const;
  Pull pull_at(Index v) const;
  void add_lines(Index v, Pull& pull) const;
  Vec3 wanted_move(Index v, const Pull& pull) const;
  bool is_too_far(Index v, const Vec3& moved, const Pull& pull) const;
  bool spoils_a_face(Index v, const Vec3& to) const;
  bool turns_to_a_neighbor(Index face, Index v, const Vec3& to) const;
  Vec3 normal_with(Index face, Index v, const Vec3& to) const;

  const std::vector<Triangle>& faces_;
  const VertexCorners& corners_;
  const FaceNeighbors& neighbors_;
  const FaceLimits& limits_;
  const MeshLines& lines_;
  const std::vector<std::uint8_t>& is_fixed_;
  std::vector<Vec3>* positions_ = nullptr;
  LargeArray<Face> fits_;
  std::vector<LineSums> line_sums_;  ///< per edge of the lines
  std::vector<Vec3> ways_;           ///< per edge of the lines, from end to end, before it was moved
  std::vector<Vec3> moves_;          ///< per vertex, so far
};

}  // namespace whittle
