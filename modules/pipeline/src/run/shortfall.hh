#pragma once

#include "whittle/pipeline/run.hh"

namespace whittle {

/// \pre the target is not met
Shortfall find_shortfall(const Plan& plan, const Simplification& simplified);

}  // namespace whittle
