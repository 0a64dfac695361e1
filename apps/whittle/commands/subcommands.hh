#pragma once

#include "options/command_line.hh"

// Each function adds a subcommand. If that one is called, parsing the command line sets `command` to its work.

namespace whittle::app {

void setup_simplify(CLI::App& app, Command& command);
void setup_measure(CLI::App& app, Command& command);
void setup_info(CLI::App& app, Command& command);
void setup_polish(CLI::App& app, Command& command);
void setup_compare(CLI::App& app, Command& command);
void setup_convert(CLI::App& app, Command& command);
void setup_verify(CLI::App& app, Command& command);
void setup_lod(CLI::App& app, Command& command);
void setup_replay(CLI::App& app, Command& command);
void setup_geomorph(CLI::App& app, Command& command);
void setup_report(CLI::App& app, Command& command);

// These two print what they know of the other subcommands. They read no mesh and have no options.
void setup_completion(CLI::App& app, Command& command);
void setup_man(CLI::App& app, Command& command);

}  // namespace whittle::app
