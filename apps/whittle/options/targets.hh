#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "whittle/pipeline/targets.hh"

namespace whittle::app {

/// \param all how the targets that there are are named in the message
/// \throw UsageError without any target.
void check_targets(const Targets& targets, const std::string& all);

/// Key `target` of the reports, without `met`: "faces", "vertices", "ratio", "face_ratio", "max_cost", "max_error" and
/// "max_error_borders", if set.
nlohmann::ordered_json target_json(const Targets& targets, const DecimateTarget& target);

}  // namespace whittle::app
