#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "complex/contraction_profile.hh"
#include "whittle/core/geometry/proof/linked_faces.hh"

namespace whittle {

/// The faces at the two vertices of a pair.
struct StarsOfPair {
  std::array<std::span<const LinkEdge>, 2> others;  ///< at each one, without the other
  std::span<const Index> opposites;                 ///< third corners of the faces at both
};

/// Tells how far a contraction moves the open border.
class BorderMotion {
 public:
  /// Whether an end of the pair that lies on the border comes to lie farther off it than a limit, or the merged vertex
  /// off the border before.
  /// \param pair its two vertices \param position_of of each vertex now \param position of the merged vertex
  template <class PositionOf>
  bool exceeds(std::array<Index, 2> pair, const StarsOfPair& stars, const PositionOf& position_of, const Vec3& position,
               double limit_sq);

 private:
  using Edges = std::vector<Corners>;  ///< triangles of which two corners are one

  /// Infinite if there are none.
  static double distance_sq_to(const Edges& edges, const Vec3& point) {
    double least = std::numeric_limits<double>::infinity();
    for (const Corners& edge : edges) least = std::min(least, distance_to(edge, point));
    return least * least;
  }
  void list_ends(std::span<const LinkEdge> faces) {
    for (const auto& [x, y] : faces) ends_.insert(ends_.end(), {x, y});
  }
  template <class PositionOf>
  void list_edges(const Vec3& from, const PositionOf& position_of, Edges& edges);

  Edges before_;
  Edges after_;
  std::vector<Index> ends_;  ///< the other corners of the faces at a vertex
};

template <class PositionOf>
bool BorderMotion::exceeds(std::array<Index, 2> pair, const StarsOfPair& stars, const PositionOf& position_of,
                           const Vec3& position, double limit_sq) {
  before_.clear();
  after_.clear();
  ends_.clear();
  for (const std::span<const LinkEdge> others : stars.others) list_ends(others);
  list_edges(position, position_of, after_);
  bool is_far = false;
  for (std::size_t end = 0; end < 2; ++end) {
    const std::size_t n_before = before_.size();
    ends_.clear();
    list_ends(stars.others[end]);
    for (const Index opposite : stars.opposites) ends_.insert(ends_.end(), {opposite, pair[1 - end]});
    const Vec3 from = position_of(pair[end]);
    list_edges(from, position_of, before_);
    if (before_.size() > n_before) is_far |= distance_sq_to(after_, from) > limit_sq;
  }
  return is_far || (!after_.empty() && distance_sq_to(before_, position) > limit_sq);
}

/// Adds an edge to each vertex that is named once in `ends_`: it has one face.
template <class PositionOf>
void BorderMotion::list_edges(const Vec3& from, const PositionOf& position_of, Edges& edges) {
  for (const Index v : ends_) {
    if (std::count(ends_.begin(), ends_.end(), v) != 1) continue;
    const Vec3 to = position_of(v);
    edges.push_back({from, to, to});
  }
}

}  // namespace whittle
