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

/// Calls `use` with each vertex that is named once: a border edge leads to it. \param ends the other corners of the
/// faces at a vertex; gets sorted
template <class Use>
void for_each_border_end(std::vector<Index>& ends, const Use& use) {
  std::sort(ends.begin(), ends.end());
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    while (end < ends.size() && ends[end] == ends[begin]) ++end;
    if (end - begin == 1) use(ends[begin]);
  }
}

/// From the nearest of some faces; infinite if there are none.
inline double distance_to_nearest(std::span<const Corners> faces, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Corners& face : faces) least = std::min(least, distance_to(face, point));
  return least;
}

/// Tells how far a contraction moves the open border.
class BorderMotion {
 public:
  /// Whether an end of the pair that lies on the border comes to lie farther off it than a limit, or the merged vertex
  /// off the border before.
  /// \param pair its two vertices \param position_of of each vertex now \param position of the merged vertex
  template <class PositionOf>
  bool exceeds(std::array<Index, 2> pair, const StarsOfPair& stars, const PositionOf& position_of, const Vec3& position,
               double limit);

 private:
  using Edges = std::vector<Corners>;  ///< triangles of which two corners are one

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
                           const Vec3& position, double limit) {
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
    if (before_.size() > n_before) is_far |= distance_to_nearest(after_, from) > limit;
  }
  return is_far || (!after_.empty() && distance_to_nearest(before_, position) > limit);
}

template <class PositionOf>
void BorderMotion::list_edges(const Vec3& from, const PositionOf& position_of, Edges& edges) {
  for_each_border_end(ends_, [&](Index v) {
    const Vec3 to = position_of(v);
    edges.push_back({from, to, to});
  });
}

}  // namespace whittle
