#pragma once

#include <string>
#include <vector>

#include "commands/recording/curve.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/report/page.hh"

namespace whittle::app {

/// A mesh of the page, and what was measured of it.
struct PageMesh {
  std::string name;
  metrics::Shape shape;
  const report::DistanceMap* distances;  ///< or null
};

/// The plots of a page: faces against error, the error, valences and shapes of all meshes.
std::vector<report::PageChart> page_charts(const std::vector<PageMesh>& meshes, const std::vector<CurvePoint>& curve);

}  // namespace whittle::app
