#include <string>
#include <vector>

#include "options/help.hh"
#include "shell/candidates.hh"
#include "shell/completion.hh"

namespace whittle::app {
namespace {

/// Text inside single quotes.
std::string zsh_text(const std::string& text) {
  std::string quoted;
  for (const char c : with_backslashes(text, "\\[]:")) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted;
}

/// ":effort:(fast normal best)": the value's name and its candidates.
std::string zsh_value(const std::string& name, const Candidates& candidates) {
  std::string action = " ";
  if (!candidates.words.empty()) {
    action = '(' + join(candidates.words) + ')';
  } else if (candidates.files == FileCandidates::meshes) {
    action = "_whittle_meshes";
  } else if (candidates.files == FileCandidates::all) {
    action = "_files";
  }
  return ':' + zsh_text(name) + ':' + action;
}

/// "'(-r --ratio)'{-r+,--ratio=}'[keep this share of the vertices]:R: '"
std::string zsh_option(const CLI::Option& option) {
  const bool has_value = takes_value(option);
  const std::vector<std::string> names = names_of(option);
  std::vector<std::string> forms;
  forms.reserve(names.size());
  for (const std::string& name : names) {
    forms.push_back(name + (!has_value ? "" : name.starts_with("--") ? "=" : "+"));
  }
  const std::string rest = '[' + zsh_text(option.get_description()) + ']' +
                           (has_value ? zsh_value(option.get_type_name(), candidates_of(option)) : "") + '\'';
  if (names.size() == 1) return '\'' + forms.front() + rest;
  return "'(" + join(names) + ")'{" + join(forms, ",") + "}'" + rest;
}

std::string zsh_case(const CLI::App& sub) {
  std::string text = "        " + sub.get_name() + ")\n          _arguments -s -S";
  for (const CLI::Option* option : named_options_of(sub)) text += " \\\n            " + zsh_option(*option);
  int number = 0;
  for (const CLI::Option* argument : arguments_of(sub)) {
    const bool is_last_of_all = argument->get_items_expected_max() > 1;
    text += " \\\n            '" + (is_last_of_all ? "*" : std::to_string(++number)) +
            zsh_value(argument->get_name(true), candidates_of(*argument)) + '\'';
  }
  return text + " && ret=0\n          ;;\n";
}

std::string zsh_subcommand(const std::string& name, const std::string& description) {
  return "        '" + name + ':' + zsh_text(description) + "'\n";
}

}  // namespace

std::string zsh_script(const CLI::App& app, const std::string& program) {
  std::string subcommands;
  std::string cases;
  std::vector<std::string> names;
  for (const CLI::App* sub : subcommands_of(app)) {
    names.push_back(sub->get_name());
    subcommands += zsh_subcommand(sub->get_name(), sub->get_description());
    cases += zsh_case(*sub);
  }
  std::string script =
      "#compdef whittle\n# Completion of whittle for zsh. Made by 'whittle completion zsh' of " + program + ".\n";
  script += "\n_whittle_meshes() {\n  _files -g '*.(#i)(" + join(mesh_extensions(), "|") + ")(-.)'\n}\n";
  script += "\n_whittle() {\n  local curcontext=$curcontext state line ret=1\n  typeset -A opt_args\n  _arguments -C";
  for (const CLI::Option* option : named_options_of(app)) script += " \\\n    " + zsh_option(*option);
  script += " \\\n    '1: :->subcommand' \\\n    '*:: :->arguments' && ret=0\n  case $state in\n    subcommand)\n";
  script += "      local -a subcommands=(\n" + subcommands + zsh_subcommand("help", "Print the help of a subcommand.");
  script += "      )\n      _describe -t commands subcommand subcommands && ret=0\n      ;;\n";
  script += "    arguments)\n      case $words[1] in\n" + cases;
  script += "        help)\n          _arguments '1:subcommand:(" + join(names) + ")' && ret=0\n          ;;\n";
  script += "      esac\n      ;;\n  esac\n  return ret\n}\n\n";
  return script + "if [[ $funcstack[1] == _whittle ]]; then\n  _whittle \"$@\"\nelse\n  compdef _whittle whittle\nfi\n";
}

}  // namespace whittle::app
