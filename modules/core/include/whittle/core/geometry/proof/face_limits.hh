#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

namespace whittle {

/// Largest allowed distance of the surface from each face: the least of its corners' tolerances and `most`. Empty
/// without tolerances.
inline std::vector<double> face_limits(std::span<const Triangle> faces, std::span<const double> tolerances,
                                       double most) {
  std::vector<double> limits;
  if (tolerances.empty()) return limits;
  limits.reserve(faces.size());
  for (const auto& [a, b, c] : faces) limits.push_back(std::min({most, tolerances[a], tolerances[b], tolerances[c]}));
  return limits;
}

}  // namespace whittle
