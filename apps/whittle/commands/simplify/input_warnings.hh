#pragma once

#include <string>
#include <vector>

#include "commands/simplify/simplify_options.hh"
#include "files/input.hh"

namespace whittle::app {

/// Lines about a mesh that was read: what of it the run won't keep, or can't keep well.
std::vector<std::string> input_warnings(const SimplifyCommand& options, const Input& input);

}  // namespace whittle::app
