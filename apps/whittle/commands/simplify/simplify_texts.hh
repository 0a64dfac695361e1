#pragma once

#include <string>
#include <vector>

#include "commands/simplify/simplify_options.hh"
#include "commands/simplify/simplify_record.hh"
#include "files/input.hh"
#include "terminal/talk.hh"

// The messages of a run of `whittle simplify`.

namespace whittle::app {

/// The lines of --verbose.
void say_details(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record);

/// "out.ply: 1000 -> 100 faces, 502 -> 52 vertices in 0.1 s"
std::string summary(const SimplifyCommand& options, const SimplifyRecord& record);

/// Content of a scene that the engine doesn't keep, a line each.
std::vector<std::string> warnings_of_engine(const SimplifyCommand& options, const Scene& scene);

}  // namespace whittle::app
