#pragma once

#include "rounds/star_planes.hh"
#include "whittle/core/detail/lanes.hh"

namespace whittle {

/// \param vertex lane → vertex
template <class VertexAt>
WHITTLE_INLINE PointLanes<Double4> lane_points(const LanePoint* points, const VertexAt& vertex) {
  const FourLanes<Double4> columns = transposed_lanes<Double4>(
      [&](std::size_t lane) WHITTLE_INLINE_LAMBDA { return points[vertex(lane)].coordinates.data(); });
  return {columns.first, columns.second, columns.third};
}

WHITTLE_INLINE PointLanes<Double4> everywhere(const LanePoint& p) {
  const auto& [x, y, z, unused] = p.coordinates;
  return {Double4{} + x, Double4{} + y, Double4{} + z};
}

}  // namespace whittle
