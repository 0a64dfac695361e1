#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace whittle::app {

/// The manual page, for `man`: all that the help says of every subcommand.
/// \param app the whole command line
/// \param program name and version, for the page's last line
std::string man_page(const CLI::App& app, const std::string& program);

}  // namespace whittle::app
