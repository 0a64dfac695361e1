#pragma once

#include "commands/simplify/simplify_options.hh"
#include "commands/simplify/simplify_record.hh"
#include "files/report.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {

/// Writes the result, the files that are asked for besides, and the report. All of them appear, or none does.
/// \param report becomes the report, even without --json; may be null
void write_files(const SimplifyCommand& options, const Talk& talk, const Stopwatch& since_start, SimplifyRecord& record,
                 Json* report);

}  // namespace whittle::app
