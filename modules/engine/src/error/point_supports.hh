#pragma once

#include <algorithm>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// For each point of the input a face of the surface that it is near to: its *support*. Supports are listed at one of
/// their corners, so that those around a pair can be found.
class PointSupports {
 public:
  /// \param n_points of the input \param n_vertices of the surface
  PointSupports(std::size_t n_points, std::size_t n_vertices)
      : supports_(n_points), next_(n_points), first_at_(n_vertices, invalid_index) {}

  /// \pre it has none
  void add(Index point, const Triangle& support) {
    supports_[point] = support;
    Index& first = first_at_[*std::min_element(support.begin(), support.end())];
    next_[point] = first;
    first = point;
  }

  const Triangle& support(Index point) const { return supports_[point]; }

  /// Calls `use` with each point whose support is listed at v.
  template <class Use>
  void for_each_at(Index v, const Use& use) const {
    for (Index point = first_at_[v]; point != invalid_index; point = next_[point]) use(point);
  }
  /// Takes the supports listed at v away of those points for which `is_to_go`.
  template <class IsToGo>
  void remove_at(Index v, const IsToGo& is_to_go) {
    for (Index* link = &first_at_[v]; *link != invalid_index;) {
      if (is_to_go(*link)) {
        *link = next_[*link];
      } else {
        link = &next_[*link];
      }
    }
  }

 private:
  std::vector<Triangle> supports_;  ///< by vertices of the surface
  std::vector<Index> next_;         ///< the next point whose support is listed in the same place
  std::vector<Index> first_at_;     ///< per vertex of the surface
};

}  // namespace whittle
