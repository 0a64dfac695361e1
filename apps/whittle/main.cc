#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "commands/subcommands.hh"
#include "files/failure.hh"
#include "files/output.hh"
#include "files/report.hh"
#include "options/command_line.hh"
#include "options/help.hh"
#include "options/parse_problems.hh"
#include "system/system.hh"
#include "terminal/errors.hh"
#include "terminal/exit_code.hh"
#include "terminal/interruption.hh"
#include "terminal/talk.hh"

namespace whittle::app {
namespace {

Talk error_talk(Volume::quiet);

int fail(ExitCode code, const std::string& problem) {
  error_talk.error(problem);
  return static_cast<int>(code);
}

std::string called_subcommand(const CLI::App& app) {
  const std::vector<CLI::App*> called = app.get_subcommands();
  return called.empty() ? std::string() : called.front()->get_name();
}

int fail_usage(const CLI::App& app, const std::string& problem) {
  const std::string sub = called_subcommand(app);
  return fail(ExitCode::usage, problem + "; see 'whittle " + (sub.empty() ? "" : sub + ' ') + "--help'");
}

std::vector<std::string> subcommand_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands({})) names.push_back(sub->get_name());
  return names;
}

std::string no_subcommand(const CLI::App& app, int argc, char** argv) {
  const std::vector<std::string> all = subcommand_names(app);
  std::string names;
  for (const std::string& name : all) names += (names.empty() ? "" : ", ") + name;
  if (argc < 2) return "a subcommand is missing: one of " + names;
  const std::string word = argv[1];
  return "'" + word + "' is not a subcommand: one of " + names + did_you_mean(word, all);
}

/// `help`, `help simplify` as `--help`, `simplify --help`. A word that is no subcommand is left, to be refused.
std::vector<char*> without_help_word(const CLI::App& app, std::vector<std::string>& words) {
  static char help[] = "--help";
  std::vector<char*> arguments(words.size());
  std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });
  if (words.size() < 2 || words[1] != "help") return arguments;
  arguments.erase(arguments.begin() + 1);
  const std::vector<std::string> names = subcommand_names(app);
  if (words.size() == 2 || std::find(names.begin(), names.end(), words[2]) != names.end()) arguments.push_back(help);
  return arguments;
}

int parse_and_run(CLI::App& app, const Command& command, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    error_talk = Talk(Volume::quiet, color_of(app));
  } catch (const CLI::Success& success) {
    std::ostringstream text;
    app.exit(success, text, text);
    print(text.str());
    return static_cast<int>(ExitCode::done);
  } catch (const CLI::ParseError& error) {
    error_talk = Talk(Volume::quiet, color_of(app));
    const std::vector<CLI::App*> called = app.get_subcommands();
    return fail_usage(app, called.empty() ? no_subcommand(app, argc, argv) : problem_of(*called.front(), error));
  }
  try {
    return static_cast<int>(command());
  } catch (const UsageError& error) {
    return fail_usage(app, error.what());
  } catch (const Interrupted& interruption) {
    std::cerr << interrupted_message;
    return 128 + interruption.signal();
  }
}

}  // namespace
}  // namespace whittle::app

int main(int argc, char** argv) {
  using namespace whittle::app;
  std::ios::sync_with_stdio(false);
  try {
    set_up_streams();
    handle_signals();
    std::vector<std::string> words = words_of_command_line(argc, argv);
    CLI::App app("Makes triangle meshes smaller and keeps their shape.", "whittle");
    app.allow_windows_style_options(false);  // "/x" is a path on Windows, too
    app.formatter(std::make_shared<HelpFormatter>());
    app.set_help_flag("-h,--help", "print this help");
    app.set_version_flag("-V,--version", program_and_version(), "print the version");
    app.require_subcommand(1);
    Command command;
    for (const auto setup : all_subcommands) setup(app, command);
    refuse_values_of_flags(app);
    app.footer(
        "'whittle SUBCOMMAND --help' tells the options of each, and so does 'whittle help SUBCOMMAND'.\n"
        "Exit status: " +
        std::string(exit_statuses));
    std::vector<char*> arguments = without_help_word(app, words);
    return parse_and_run(app, command, static_cast<int>(arguments.size()), arguments.data());
  } catch (...) {
    const Failure failure = current_failure();
    return fail(failure.code, failure.problem);
  }
}
