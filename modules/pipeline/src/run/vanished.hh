#pragma once

#include "whittle/core/regions.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/pipeline/run.hh"

namespace whittle {

Vanished find_vanished(const Scene& scene, const Decimation& result, const RegionNames& names);

}  // namespace whittle
