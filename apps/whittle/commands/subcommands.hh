#pragma once

#include "options/command_line.hh"

// Each adds a subcommand that, when it is the one called, leaves what is to be done in `command`.

namespace whittle::app {

void setup_simplify(CLI::App& app, Command& command);
void setup_measure(CLI::App& app, Command& command);
void setup_info(CLI::App& app, Command& command);
void setup_polish(CLI::App& app, Command& command);
void setup_compare(CLI::App& app, Command& command);

}  // namespace whittle::app
