#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace whittle::app {

/// Which files a shell offers for a value.
enum class FileCandidates { none, meshes, all };

/// The candidates that a shell offers for the value of an option.
struct Candidates {
  std::vector<std::string> words;  ///< in lower case: "fast", "auto"
  FileCandidates files = FileCandidates::none;
};

/// The candidates by the value's name in the help: "fast|normal|best", "T|auto", "EXT", "EXT|glb", "FILE|-", "OUT".
/// Arguments are mesh files, unless they have such a name.
Candidates candidates_of(const CLI::Option& option);

/// "obj", "ply", "obj.gz", "glb", …: how names of mesh files end, in lower case.
std::vector<std::string> mesh_extensions();

/// "-r", "--ratio"
std::vector<std::string> names_of(const CLI::Option& option);

/// The subcommands, in the order of the help.
std::vector<const CLI::App*> subcommands_of(const CLI::App& app);

/// The options that have a name.
std::vector<const CLI::Option*> named_options_of(const CLI::App& app);

/// The arguments without a name, in their order.
std::vector<const CLI::Option*> arguments_of(const CLI::App& app);

/// "a b c"
std::string join(const std::vector<std::string>& words, const std::string& separator = " ");

/// Each character of `special` in `text` with a backslash before it.
std::string with_backslashes(const std::string& text, const std::string& special);

}  // namespace whittle::app
