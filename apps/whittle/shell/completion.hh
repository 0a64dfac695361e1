#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace whittle::app {

/// The shells that completion scripts are made for.
enum class Shell { bash, zsh, fish };

/// A script that completes calls of the program: subcommands, options, their values, and names of mesh files.
/// \param app the whole command line; the script offers its subcommands and options, and `help`
/// \param program name and version, for a comment
std::string completion_script(Shell shell, const CLI::App& app, const std::string& program);

// One function a shell, each in a file of its own. Other files call `completion_script`.
std::string bash_script(const CLI::App& app, const std::string& program);
std::string zsh_script(const CLI::App& app, const std::string& program);
std::string fish_script(const CLI::App& app, const std::string& program);

}  // namespace whittle::app
