#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/report.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/metrics/topology.hh"
#include "whittle/report/page.hh"

// The tables of the page, for people. All figures are in its JSON.

namespace whittle::app {

/// A mesh file, as it was measured.
struct MeasuredMesh {
  std::string name;
  metrics::Topology topology;
  metrics::Shape shape;
  std::optional<metrics::SurfaceDistance> distance;  ///< from the original; the original has none
};

/// A column a mesh, the original's first; a row a quantity.
report::PageTable mesh_table(const std::vector<MeasuredMesh>& meshes);

/// What a run was asked for and what it did. \param report of one run of `simplify`
report::PageTable run_table(const std::string& title, const Json& report);

}  // namespace whittle::app
