#pragma once

#include <vector>

#include "whittle/core/geometry/image_triangle.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::bake {

/// Faces that are projected together.
struct Chart {
  Vec3 axis;                 ///< Unit length, on the side of the faces' fronts.
  std::vector<Index> faces;  ///< In the order of growth.
};

/// Faces on a plane, none over another.
struct FlatChart {
  Vec3 right;  ///< Unit length; the plane's first direction.
  std::vector<Index> faces;
  std::vector<detail::ImageTriangle> triangles;  ///< Per face; model units, in a rectangle from (0, 0), rows go down.
  detail::Vec2 extent;                           ///< Of the rectangle; it isn't higher than wide.
};

/// Charts that together have each face once. The largest face that is left begins a chart.
/// \param positions near the origin
std::vector<Chart> make_charts(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces);

/// Projects a chart. Faces that would lie over others are split off, as charts of their own.
std::vector<FlatChart> lay_flat(const std::vector<Vec3>& positions, const std::vector<Triangle>& faces, Chart chart);

}  // namespace whittle::bake
