#pragma once

#include <vector>

#include "whittle/pipeline/run.hh"

namespace whittle {

/// What may surprise in a result. \param outcome but for its warnings
std::vector<RunWarning> find_warnings(const Plan& plan, const Outcome& outcome);

}  // namespace whittle
