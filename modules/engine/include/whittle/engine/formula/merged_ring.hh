#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/detail/lanes.hh"
#include "whittle/engine/formula/flip_limit.hh"
#include "whittle/engine/formula/memoryless_term.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {

struct Pair;
struct PairStar;
class TriangleComplex;

/// The neighbours of both ends of an inner edge, once around: the ring that the merged vertex will have. Each two in
/// succession, the last and the first too, are the other corners of a face at one of the ends.
///
/// A sum over these faces is that of four sums, each over every fourth face, from the first end's on: the same on all
/// processors.
class MergedRing {
 public:
  /// An inner edge and the vertices around it.
  struct Edge {
    Index first, second;            ///< its ends
    std::span<const Index> around;  ///< counter-clockwise from the corner left of the edge on: the first end's other
                                    ///< neighbours, then the second end's but for the two corners opposite the edge
    std::size_t n_first;            ///< faces at the first end alone: the place of the corner right of the edge
  };

  /// \param star of the pair, as gathered \pre both ends have rings
  /// \param origin what everything here is seen from
  void assign(const TriangleComplex& complex, const Pair& pair, const PairStar& star, const Vec3& origin);
  /// \param position_of vertex number → Vec3
  template <class PositionOf>
  void assign(const Edge& edge, const Vec3& origin, const PositionOf& position_of) {
    vertices_.assign(edge.around.begin(), edge.around.end());
    n_first_ = edge.n_first;
    first_ = position_of(edge.first) - origin;
    second_ = position_of(edge.second) - origin;
    load_neighbours(origin, position_of);
    look_at_faces();
  }

  std::size_t size() const { return vertices_.size(); }
  Index vertex(std::size_t i) const { return vertices_[i]; }

  /// Of the faces as they are, those of both ends included.
  const StarVolume& volume() const { return volume_; }

  /// How far the faces, and those with the merged vertex at `apex`, are from each other, about: the farthest that an
  /// end is from these, or `apex` from those.
  double displacement_sq(const Vec3& apex) const;

  /// Looks at the faces as they would be with the merged vertex at `apex`. \return whether one turns too far
  /// \pre planes have weights by area
  bool move_to(const Vec3& apex, const FlipLimit& limit, const QuadricOptions& options);
  /// The sum of their planes then.
  const SymmetricMatrix& planes() const { return planes_; }
  /// By how much that changes the planes at the i-th neighbour.
  SymmetricMatrix change(std::size_t i) const {
    SymmetricMatrix change = changes_[i == 0 ? size() - 1 : i - 1].planes + changes_[i].planes;
    if (i == 0) change -= vanished_[0].planes;
    if (i == n_first_) change -= vanished_[1].planes;
    return change;
  }

 private:
  using Columns = std::array<std::vector<double>, 3>;
  /// A column a number, a row a face: so lanes are loaded and stored at once.
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
  std::size_t n_first_ = 0;       ///< faces at the first end alone; the opposite corners are at places 0 and this
  Vec3 first_, second_;           ///< the ends
  Columns neighbours_;            ///< the first one again at the end, and some more for lanes to load
  std::vector<FourFaces> faces_;  ///< at one end, as they are
  FourFaces common_;              ///< the two at both, and two without area
  StarVolume volume_;
  SymmetricMatrix planes_;
  std::vector<Change> changes_;     ///< what the faces' planes gain and lose
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
