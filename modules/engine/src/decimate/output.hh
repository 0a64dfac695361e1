#pragma once

#include <vector>

#include "loop/remainder.hh"
#include "whittle/core/frame.hh"
#include "whittle/engine/decimate.hh"

namespace whittle {

/// The mesh and the maps of a decimation, without its attributes; `result` is left to the caller.
Decimation geometry_of(const IndexedMesh& input, Remainder left, const Frame& frame);

}  // namespace whittle
