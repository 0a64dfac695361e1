#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "files/input.hh"
#include "whittle/core/regions.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::app {

/// \throw UnsupportedMesh if no face attribute of the input has one of the names
void check_regions(const RegionNames& names, const Input& input);

/// What the input has and the result hasn't.
struct Vanished {
  std::vector<std::string> regions;  ///< materials, groups and the like: "material red", "g wheel", "label 7"
  std::size_t n_charts = 0;          ///< areas between seams, in regions that are left
};
Vanished find_vanished(const Input& input, const Decimation& result, const RegionNames& names);

/// A sentence for regions, and one for charts, if there are any; without full stops.
std::vector<std::string> texts_of(const Vanished& vanished);

}  // namespace whittle::app
