#pragma once

#include "commands/simplify/simplify_options.hh"
#include "commands/simplify/simplify_record.hh"
#include "files/report.hh"

namespace whittle::app {

/// The JSON report of a run: docs/user/simplify.md has its keys.
Json simplify_json(const SimplifyCommand& options, const SimplifyRecord& record);

}  // namespace whittle::app
