#pragma once

#include "whittle/metrics/distance.hh"
#include "whittle/pipeline/option.hh"

namespace whittle::app {

/// --samples and --seed.
OptionRows sampling_rows(metrics::DistanceOptions& options);

}  // namespace whittle::app
