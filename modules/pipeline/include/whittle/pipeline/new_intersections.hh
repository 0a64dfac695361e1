#pragma once

#include <string>
#include <vector>

#include "whittle/engine/decimate.hh"

namespace whittle {

/// New intersections of a result, for warnings.
struct NewIntersections {
  std::string of_parts;  ///< "2 pairs of parts intersect that didn't before", or empty
  std::string of_walls;  ///< the same for faces of one part
};
NewIntersections find_new_intersections(const IndexedMesh& before, const Decimation& result, unsigned threads);

}  // namespace whittle
