#pragma once

#include <span>
#include <vector>

#include "complex/areas_of_faces.hh"

namespace whittle {

/// How many faces of each area (`seam_areas`) are left, so that the last ones stay.
class AreaCounts {
 public:
  /// No areas.
  AreaCounts() = default;
  explicit AreaCounts(const AreasOfFaces& areas) : of_(areas.of) {
    for (const Index area : of_) {
      if (area == invalid_index) continue;
      if (area >= n_left_.size()) n_left_.resize(area + 1);
    }
  }

  bool any() const { return !n_left_.empty(); }
  void add(Index face) {
    if (of_[face] != invalid_index) ++n_left_[of_[face]];
  }
  void remove(std::span<const Index> faces) {
    for (const Index face : faces) {
      if (of_[face] != invalid_index) --n_left_[of_[face]];
    }
  }
  /// Whether an area has no other faces than these. \param faces two at most
  bool end_with(std::span<const Index> faces) const {
    for (const Index face : faces) {
      const Index area = of_[face];
      if (area == invalid_index) continue;
      std::size_t n = 0;
      for (const Index other : faces) n += static_cast<std::size_t>(of_[other] == area);
      if (n_left_[area] == n) return true;
    }
    return false;
  }

 private:
  std::span<const Index> of_;        ///< per face
  std::vector<std::size_t> n_left_;  ///< by area
};

}  // namespace whittle
