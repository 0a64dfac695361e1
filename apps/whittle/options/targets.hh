#pragma once

#include <string>

#include "whittle/pipeline/targets.hh"

namespace whittle::app {

/// \param all how the targets that there are are named in the message
/// \throw UsageError without any target.
void check_targets(const Targets& targets, const std::string& all);

}  // namespace whittle::app
