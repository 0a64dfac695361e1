#pragma once

#include "whittle/core/regions.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/pipeline/run.hh"

namespace whittle {

/// \throw UnsupportedMesh if no face attribute of the scene has one of the names
void check_regions(const RegionNames& names, const Scene& scene);

Vanished find_vanished(const Scene& scene, const Decimation& result, const RegionNames& names);

}  // namespace whittle
