#pragma once

#include <string>
#include <vector>

#include "commands/simplify/simplify_options.hh"
#include "commands/simplify/simplify_record.hh"
#include "files/input.hh"
#include "terminal/talk.hh"

// What a run of `whittle simplify` says in words.

namespace whittle::app {

/// "refused: 12 by topology, 3 by turning a face, 0 locked"
std::string refusals(const SimplifyCommand& options, const RefusalCounts& refused);

/// The lines of --verbose.
void say_details(const SimplifyCommand& options, const Talk& talk, const SimplifyRecord& record);

/// "out.ply: 1000 -> 100 faces, 502 -> 52 vertices in 0.1 s"
std::string summary(const SimplifyCommand& options, const SimplifyRecord& record);

/// Lines about a mesh that was read: what of it the run won't keep, or can't keep well.
std::vector<std::string> input_warnings(const SimplifyCommand& options, const Input& input);

}  // namespace whittle::app
