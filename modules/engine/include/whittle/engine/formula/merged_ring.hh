#pragma once

#include <array>
#include <vector>

#include "whittle/core/detail/lanes.hh"
#include "whittle/engine/formula/flip_limit.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {

/// The neighbours of both ends of an inner edge, once around: the one-ring that the merged vertex will have. Two in
/// succession, cyclically, are the other corners of a face at one of the ends.
///
///          v0 --- v4          a, b: the ends; v0 lies left of the edge a b, v2 right of it
///        / | \   / |          v0 v1 v2: neighbours of a, `n_first` = 2 faces
///      v1--a-----b--v3        v2 v3 v4 v0: neighbours of b
///        \ | /   \ |
///          v2 --- v3
///
/// A sum over these faces is made of four sums, each over every fourth face, beginning with the first end's: the same
/// on all processors.
class MergedRing {
 public:
  /// To be filled before `look`, counter-clockwise from the vertex left of the edge: the first end's other neighbours,
  /// then the second end's without the two opposite vertices.
  std::vector<Index>& around() { return vertices_; }

  /// Looks at the faces as they are. \pre `around` is filled
  /// \param first, second positions of the ends \param n_first number of faces at the first end alone: the slot of the
  ///        vertex right of the edge \param origin all numbers in here are relative to it
  /// \param position_of vertex number → Vec3
  template <class PositionOf>
  void look(const Vec3& first, const Vec3& second, std::size_t n_first, const Vec3& origin,
            const PositionOf& position_of) {
    n_first_ = n_first;
    origin_ = origin;
    first_ = first - origin;
    second_ = second - origin;
    load_neighbours(origin, position_of);
    look_at_faces();
  }

  std::size_t size() const { return vertices_.size(); }
  Index vertex(std::size_t i) const { return vertices_[i]; }

  /// Of the faces as they are, including those that both ends have.
  const StarVolume& volume() const { return volume_; }

  /// About how far the faces move if the merged vertex is at `position`: the largest of the distances of the two ends
  /// from the faces afterwards and of `position` from the faces before.
  double displacement_sq(const Vec3& position) const;

  /// Looks at the faces as they would be with the merged vertex at `position`. \pre planes have weights by area
  void move_to(const Vec3& position, const QuadricOptions& options);
  /// The position of the last `move_to`. \pre `move_to` was called since `look`
  const Vec3& moved_to() const { return moved_to_; }
  /// Least cosine between a face's normals before and after: −∞ where one loses its area, ∞ if none had one.
  double least_cosine() const { return least_cosine_; }
  /// The sum of the faces' planes after.
  const SymmetricMatrix& planes() const { return planes_; }
  /// The change of the planes at the i-th neighbour.
  SymmetricMatrix change(std::size_t i) const {
    SymmetricMatrix change = changes_[i == 0 ? size() - 1 : i - 1].planes + changes_[i].planes;
    if (i == 0) change -= vanished_[0].planes;
    if (i == n_first_) change -= vanished_[1].planes;
    return change;
  }

 private:
  using Columns = std::array<std::vector<double>, 3>;
  /// A column for each number, a row for each face, so that lanes are loaded and stored at once.
  struct alignas(32) FourFaces {
    using Lanes = std::array<double, 4>;
    std::array<Lanes, 3> normal;  ///< of unit length, or zero
    Lanes length;                 ///< twice the area
    Lanes had_area;               ///< 1 or 0
  };
  /// Stored four at a time.
  struct alignas(32) Change {
    SymmetricMatrix planes;
    std::array<double, 2> unused;
  };
  struct Kernels;
  static constexpr std::size_t at_once = n_lanes<Double4>;

  template <class PositionOf>
  void load_neighbours(const Vec3& origin, const PositionOf& position_of);
  void look_at_faces();
  Vec3 neighbour(std::size_t i) const { return {neighbours_[0][i], neighbours_[1][i], neighbours_[2][i]}; }

  std::vector<Index> vertices_;
  std::size_t n_first_ = 0;  ///< faces at the first end alone; the opposite corners are at places 0 and this
  Vec3 origin_;
  Vec3 first_, second_;           ///< the ends
  Columns neighbours_;            ///< at the end the first one again, as often as lanes load it
  std::vector<FourFaces> faces_;  ///< at one end, as they are
  FourFaces common_;              ///< the two at both, and two without area
  StarVolume volume_;
  Vec3 moved_to_;
  double least_cosine_ = 0;
  SymmetricMatrix planes_;
  std::vector<Change> changes_;     ///< of each face's planes
  std::array<Change, 4> vanished_;  ///< of the two faces at both ends, and of two without area
};

template <class PositionOf>
void MergedRing::load_neighbours(const Vec3& origin, const PositionOf& position_of) {
  const std::size_t n = vertices_.size();
  if (changes_.size() < n + at_once) {
    changes_.resize(2 * (n + at_once));
    faces_.resize(changes_.size() / at_once);
    for (std::vector<double>& column : neighbours_) column.resize(changes_.size() + 1);
  }
  const std::size_t n_loaded = (n + at_once - 1) / at_once * at_once + 1;
  for (std::size_t i = 0; i < n_loaded; ++i) {
    const Vec3 p = position_of(vertices_[i < n ? i : 0]) - origin;
    neighbours_[0][i] = p.x();
    neighbours_[1][i] = p.y();
    neighbours_[2][i] = p.z();
  }
}

}  // namespace whittle
