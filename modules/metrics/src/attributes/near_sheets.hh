#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "attributes/surface_attribute.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle::metrics {

/// The faces near a point, and the sheets that they form. It is used again for the next point.
class NearSheets {
 public:
  /// Finds the faces that are within a distance; of more than 64 the nearest ones. \param most_sq that distance,
  /// squared
  void find(const TriangleTree& tree, const Vec3& point, double most_sq);

  /// Calls `visit(nearest)` with the nearest point of each sheet: of faces that are connected, within the distance,
  /// over corners where the attribute is continuous.
  template <class Visitor>
  void for_each_sheet(const SurfaceAttribute& attribute, Visitor&& visit) {
    if (near_.size() == 1) return visit(near_.front());
    join(attribute);
    for (std::size_t i = 0; i < near_.size(); ++i) {
      if (sheets_[i] == i) visit(near_[i]);
    }
  }

 private:
  static constexpr std::size_t most_faces = 64;

  void join(const SurfaceAttribute& attribute);
  std::size_t root(std::size_t i);

  std::vector<ClosestPoint> near_;                      ///< by distance, then by face
  std::vector<std::size_t> sheets_;                     ///< of each a face of the same sheet that isn't farther
  std::vector<std::pair<Index, std::size_t>> corners_;  ///< a number of continuity, and who has it
};

}  // namespace whittle::metrics
