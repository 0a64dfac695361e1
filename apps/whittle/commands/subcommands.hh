#pragma once

#include <array>

#include "options/subcommand.hh"

// Each function adds a subcommand. If the user calls it, parsing the command line sets `command` to its work.

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
void setup_bake(CLI::App& app, Command& command);
void setup_geomorph(CLI::App& app, Command& command);
void setup_report(CLI::App& app, Command& command);

// These two describe the other subcommands. They read no mesh.
void setup_completion(CLI::App& app, Command& command);
void setup_man(CLI::App& app, Command& command);

/// All subcommands, in the order of the help.
inline constexpr std::array all_subcommands{
    setup_simplify, setup_measure, setup_info,   setup_polish,   setup_compare, setup_convert,    setup_verify,
    setup_lod,      setup_bake,    setup_replay, setup_geomorph, setup_report,  setup_completion, setup_man};

}  // namespace whittle::app
