#pragma once

#include <CLI/CLI.hpp>

#include "whittle/metrics/distance.hh"

namespace whittle::app {

/// Adds --samples and --seed.
void add_sampling_options(CLI::App& app, metrics::DistanceOptions& options);

}  // namespace whittle::app
