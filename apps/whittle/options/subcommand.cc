#include "options/subcommand.hh"

#include <CLI/CLI.hpp>
#include <utility>

#include "options/help.hh"
#include "terminal/errors.hh"

namespace whittle::app {
namespace {

constexpr char argument_group[] = "Arguments";
constexpr char default_group[] = "Options";  // CLI11's name of the group of options without one

constexpr int most_arguments = 1 << 24;  // more than a command line can have

bool is_argument(const OptionRow& row) { return !row.names.starts_with('-'); }

CLI::Option* add_flag(CLI::App& app, const OptionRow& row) {
  return app.add_flag_callback(
      row.names, [set = row.access.set] { set("on"); }, row.help);
}

CLI::Option* add_valued(CLI::App& app, const OptionRow& row) {
  const auto take = [set = row.access.set, name = long_name(row)](const CLI::results_t& texts) {
    try {
      for (const std::string& text : texts) set(text);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(name, error.what());
    }
    return true;
  };
  return app.add_option(row.names, take, row.help)->type_name(row.access.meta);
}

void add_option(CLI::App& app, const OptionRow& row) {
  if (row.names.empty()) return;  // it is reported alone
  const bool is_flag = !is_argument(row) && row.access.meta.empty();
  CLI::Option* option = is_flag ? add_flag(app, row) : add_valued(app, row);
  if (row.is_required) option->required();
  if (row.takes_several) option->expected(1, most_arguments)->allow_extra_args();
  if (is_argument(row)) {
    option->group(argument_group);
    return;
  }
  option->group(row.group.empty() ? default_group : row.group);
  if (!row.is_required) option->default_str(row.standard.empty() ? to_string(row.access.get()) : row.standard);
}

bool is_given_in(const CLI::App& app, const std::string& side) {
  const std::size_t space = side.find(' ');
  const CLI::Option* option = app.get_option_no_throw(side.substr(0, space));
  if (option == nullptr || option->count() == 0) return false;
  return space == std::string::npos || option->results().front() == side.substr(space + 1);
}

ExitCode check_and_run(const CLI::App& app, const OptionRows& rows, const std::function<ExitCode(const Given&)>& run) {
  Given given{[&app](const std::string& side) { return is_given_in(app, side); }, {}};
  const std::string conflict = find_conflict(rows, given.is_given);
  if (!conflict.empty()) throw UsageError(conflict);
  given.idle = find_idle(rows, given.is_given);
  return run(given);
}

}  // namespace

void add_subcommand(CLI::App& app, const SubcommandText& text, OptionRows rows,
                    std::function<ExitCode(const Given&)> run, Command& command) {
  CLI::App* sub = app.add_subcommand(text.name, text.meaning);
  for (const OptionRow& row : rows) add_option(*sub, row);
  sub->set_help_flag("-h,--help", "print this help")->group(common_group);
  set_usage(*sub, text.usage);
  sub->footer(text.footer);
  sub->callback([sub, rows = std::move(rows), run = std::move(run), &command] {
    command = [sub, &rows, &run] { return check_and_run(*sub, rows, run); };
  });
}

void refuse_values_of_flags(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (!takes_value(*option)) option->disable_flag_override();
  }
  for (CLI::App* sub : app.get_subcommands({})) refuse_values_of_flags(*sub);
}

}  // namespace whittle::app
