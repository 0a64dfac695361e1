#pragma once

#include <string>

#include "commands/measure/posed.hh"
#include "files/report.hh"

namespace whittle::app {

/// {"poses", "animated", "diagonal", "rest", "average", "worst", "ratio"}
Json posed_json(const PosedDistance& posed);

/// The same for people.
std::string posed_table(const PosedDistance& posed);

}  // namespace whittle::app
