#include <string>
#include <vector>

#include "options/help.hh"
#include "shell/candidates.hh"
#include "shell/completion.hh"

namespace whittle::app {
namespace {

/// The text before the table: whether a subcommand was typed, and names of mesh files and folders.
constexpr char fish_helpers[] = R"(
function __whittle_runs
    set -l words (commandline -opc)
    test (count $words) -ge 2; and contains -- $words[2] $argv
end

function __whittle_runs_nothing
    test (count (commandline -opc)) -lt 2
end

function __whittle_meshes
    __fish_complete_path (commandline -ct) | string match -rei '(?:/|\.(?:@EXTENSIONS@))(?:\t.*)?$'
end

complete -c whittle -f
)";

std::string fish_text(const std::string& text) { return '\'' + with_backslashes(text, "\\'") + '\''; }

std::string fish_rule(const std::string& condition, const std::string& what, const std::string& description) {
  return "complete -c whittle -n '" + condition + "'" + what + " -d " + fish_text(description) + '\n';
}

/// " -x -a 'fast normal best'"
std::string fish_value(const Candidates& candidates) {
  if (!candidates.words.empty()) return " -x -a " + fish_text(join(candidates.words));
  switch (candidates.files) {
    case FileCandidates::meshes:
      return " -x -a '(__whittle_meshes)'";
    case FileCandidates::all:
      return " -r -F";
    case FileCandidates::none:
      break;
  }
  return " -x";
}

std::string fish_option(const std::string& condition, const CLI::Option& option) {
  std::string what;
  for (const std::string& name : option.get_snames()) what += " -s " + name;
  for (const std::string& name : option.get_lnames()) what += " -l " + name;
  if (takes_value(option)) what += fish_value(candidates_of(option));
  return fish_rule(condition, what, option.get_description());
}

}  // namespace

std::string fish_script(const CLI::App& app, const std::string& program) {
  std::string helpers = fish_helpers;
  const std::string place = "@EXTENSIONS@";
  helpers.replace(helpers.find(place), place.size(), with_backslashes(join(mesh_extensions(), "|"), "."));
  std::string script =
      "# Completion of whittle for fish. Made by 'whittle completion fish' of " + program + ".\n" + helpers;
  for (const CLI::Option* option : named_options_of(app)) script += fish_option("__whittle_runs_nothing", *option);
  script += fish_rule("__whittle_runs_nothing", " -a help", "Print the help of a subcommand.");
  for (const CLI::App* sub : subcommands_of(app)) {
    script += fish_rule("__whittle_runs_nothing", " -a " + sub->get_name(), sub->get_description());
    script += fish_rule("__whittle_runs help", " -a " + sub->get_name(), sub->get_description());
    const std::string condition = "__whittle_runs " + sub->get_name();
    for (const CLI::Option* option : named_options_of(*sub)) script += fish_option(condition, *option);
    const std::vector<const CLI::Option*> arguments = arguments_of(*sub);
    if (arguments.empty()) continue;
    script += fish_rule(condition, fish_value(candidates_of(*arguments.back())), arguments.front()->get_description());
  }
  return script;
}

}  // namespace whittle::app
