#pragma once

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// \throw std::invalid_argument if a face names a missing vertex.
inline void check_corners(std::size_t n_vertices, std::span<const Triangle> faces) {
  for (const Triangle& face : faces) {
    for (const Index v : face) {
      if (v < n_vertices) continue;
      throw std::invalid_argument("face " + std::to_string(&face - faces.data()) + " names vertex " +
                                  std::to_string(v) + " of " + std::to_string(n_vertices));
    }
  }
}

/// The largest allowed coordinate of a mesh: squares of lengths must be finite.
constexpr double most_coordinate = 0x1p500;  // 3.3e150

/// Whether all three are numbers of at most `most_coordinate`.
inline bool is_in_range(const Vec3& p) {
  return std::abs(p.x()) <= most_coordinate && std::abs(p.y()) <= most_coordinate && std::abs(p.z()) <= most_coordinate;
}

/// \param caller whose name begins the message
/// \throw std::invalid_argument if a coordinate is not finite or above `most_coordinate`.
inline void check_positions(std::span<const Vec3> positions, const char* caller) {
  for (const Vec3& p : positions) {
    if (is_in_range(p)) continue;
    throw std::invalid_argument(std::string(caller) + ": vertex " + std::to_string(&p - positions.data()) +
                                " has a coordinate that is not finite, or above 3e150");
  }
}

/// \param caller whose name begins the message
/// \throw std::invalid_argument if a non-empty attribute has another length than `IndexedMesh` says, if an attribute
///        other than scalars and categories is not finite, or if a wedge is at two vertices.
/// \pre no face names a missing vertex
void check_attributes(const IndexedMesh& mesh, const char* caller);

}  // namespace whittle
