#pragma once

#include <string>
#include <string_view>

#include "whittle/pipeline/request.hh"

namespace whittle {

/// Options for costs, placement and polish.
OptionRows cost_rows(Request& request);

/// Adds the costs that a row's option doesn't go with. \param value of the option; empty = any
void append_costs_against(OptionRow& row, std::string_view CostConflicts::*why, const std::string& value = "");

}  // namespace whittle
