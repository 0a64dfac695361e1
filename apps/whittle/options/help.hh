#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace whittle::app {

/// The exit statuses of all calls.
inline constexpr char exit_statuses[] =
    "0 done, 1 failure, 2 usage, 3 target not met (--strict), 4 input unreadable or invalid,\n130 interrupted.";

/// The title of the options that every subcommand has.
inline constexpr char common_group[] = "Common options";

/// Options under a title.
struct OptionGroup {
  std::string title;
  std::vector<const CLI::Option*> options;
};

/// The options as the help lists them. Arguments without a name come first.
std::vector<OptionGroup> option_groups(const CLI::App& app);

/// Whether a value follows the option's name.
bool takes_value(const CLI::Option& option);

/// "-r, --ratio R", "--json FILE|-", "IN"
std::string shown_name(const CLI::Option& option);

/// The description, and "(default: …)" or "(required)".
std::string shown_description(const CLI::Option& option);

/// Sets the text that follows "Usage: whittle NAME" in the help. It is stored at the option --help, because in CLI11
/// only options can hold such a text.
void set_usage(CLI::App& subcommand, const std::string& usage);
/// The text after "whittle simplify " in a call: "IN -o OUT TARGET... [OPTION]...".
std::string usage_of(const CLI::App& subcommand);

/// Help in lines of at most 100 columns. The name of an option is on the left: "  -r, --ratio R". The description
/// starts at column 30, on the next line if the name is too long. It ends with "(default: …)" or "(required)".
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace whittle::app
