#pragma once

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "whittle/core/geometry/bounds.hh"

namespace whittle::metrics {

/// The power of two to multiply coordinates by before products of several lengths are taken, so that these neither
/// over- nor underflow. 1 for meshes of ordinary size. Multiplying by it loses nothing. A tiny mesh far from the origin
/// is not enlarged more than its place allows.
inline double working_scale(std::initializer_list<Box> boxes) {
  constexpr int largest_exponent = 200;
  constexpr int farthest_exponent = 400;
  constexpr int most_exponent = 1000;  // its power of two and the inverse are numbers
  double extent = 0.0;
  double farthest = 0.0;
  for (const Box& box : boxes) {
    extent = std::max(extent, box.sizes().maxCoeff());
    farthest = std::max({farthest, box.max().maxCoeff(), -box.min().minCoeff()});
  }
  if (!(extent > 0.0)) return 1.0;
  const int exponent = std::ilogb(extent);
  if (std::abs(exponent) <= largest_exponent) return 1.0;
  const int most = std::clamp(farthest_exponent - std::ilogb(farthest), 0, most_exponent);
  return std::ldexp(1.0, std::clamp(-exponent, -most_exponent, most));
}

/// Positions and faces of the mesh, without its attributes, at another scale.
inline IndexedMesh scaled(const IndexedMesh& mesh, double scale) {
  IndexedMesh result;
  result.faces = mesh.faces;
  result.positions.reserve(mesh.positions.size());
  for (const Vec3& p : mesh.positions) result.positions.emplace_back(p * scale);
  return result;
}

}  // namespace whittle::metrics
