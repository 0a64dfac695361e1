#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "terminal/exit_code.hh"
#include "whittle/pipeline/option.hh"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace whittle::app {

/// The work of a subcommand. It runs after the command line has been parsed.
using Command = std::function<ExitCode()>;

/// The help of a subcommand, without its options.
struct SubcommandText {
  const char* name;
  const char* meaning;
  const char* usage;   ///< text after "whittle NAME"
  const char* footer;  ///< examples
};

/// Facts about the command line, besides values.
struct Given {
  IsGiven is_given;
  std::vector<std::string> idle;  ///< a warning for each option that does nothing as things are
};

/// Adds a subcommand with the options `rows` and the common options. If it is called, parsing sets `command` to `run`,
/// which first refuses conflicting options.
void add_subcommand(CLI::App& app, const SubcommandText& text, OptionRows rows,
                    std::function<ExitCode(const Given&)> run, Command& command);

/// The same for options that `rows_of` lists.
template <class Options>
void add_subcommand(CLI::App& app, const SubcommandText& text, const Options& defaults, OptionRows (*rows_of)(Options&),
                    ExitCode (*run)(const Given&, Options), Command& command) {
  const auto options = std::make_shared<Options>(defaults);
  add_subcommand(
      app, text, rows_of(*options), [options, run](const Given& given) { return run(given, *options); }, command);
}

/// Makes "--quiet=3" an error: CLI11 gives flags such values otherwise.
void refuse_values_of_flags(CLI::App& app);

}  // namespace whittle::app
