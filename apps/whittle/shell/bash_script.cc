#include <string>
#include <vector>

#include "options/help.hh"
#include "shell/candidates.hh"
#include "shell/completion.hh"

namespace whittle::app {
namespace {

/// The text before the table. `cur` is the text to complete, `prefix` the text before it in the same word.
constexpr char bash_helpers[] = R"(
_whittle_words() {
  mapfile -t COMPREPLY < <(compgen -P "$prefix" -W "$1" -- "$cur")
}

_whittle_files() {
  compopt -o filenames 2> /dev/null
  mapfile -t COMPREPLY < <(compgen -P "$prefix" -f -- "$cur")
}

_whittle_meshes() {
  local pattern
  compopt -o filenames 2> /dev/null
  mapfile -t COMPREPLY < <(
    compgen -P "$prefix" -d -- "$cur"
    for pattern in @PATTERNS@; do
      compgen -P "$prefix" -f -X "!$pattern" -- "$cur"
    done
  )
}

_whittle() {
  local cur=${COMP_WORDS[COMP_CWORD]} prefix= option= subcommand=
  COMPREPLY=()
  ((COMP_CWORD > 1)) && subcommand=${COMP_WORDS[1]}
  # By default bash cuts --effort=fast into three words.
  if [[ $cur == --*=* ]]; then
    option=${cur%%=*} prefix=${cur%%=*}= cur=${cur#*=}
  elif [[ $cur == = ]]; then
    option=${COMP_WORDS[COMP_CWORD - 1]} cur=
  elif [[ ${COMP_WORDS[COMP_CWORD - 1]} == = ]]; then
    option=${COMP_WORDS[COMP_CWORD - 2]}
  elif [[ ${COMP_WORDS[COMP_CWORD - 1]} == -* ]]; then
    option=${COMP_WORDS[COMP_CWORD - 1]}
  fi
  case $subcommand:$option in
)";

/// "*.[oO][bB][jJ]"
std::string any_case(const std::string& extension) {
  std::string pattern = "'*.";
  for (const char c : extension) {
    const bool is_letter = c >= 'a' && c <= 'z';
    pattern += is_letter ? std::string{'[', c, static_cast<char>(c - 'a' + 'A'), ']'} : std::string(1, c);
  }
  return pattern + '\'';
}

std::string bash_patterns() {
  std::vector<std::string> patterns;
  for (const std::string& extension : mesh_extensions()) patterns.push_back(any_case(extension));
  return join(patterns);
}

/// A call that completes such a value; empty if there is nothing to offer.
std::string bash_call(const Candidates& candidates) {
  if (!candidates.words.empty()) return "_whittle_words '" + join(candidates.words) + "'";
  switch (candidates.files) {
    case FileCandidates::meshes:
      return "_whittle_meshes";
    case FileCandidates::all:
      return "_whittle_files";
    case FileCandidates::none:
      break;
  }
  return {};
}

/// "    simplify:--effort) _whittle_words 'fast normal best'; return ;;"
std::string bash_value_rule(const CLI::App& subcommand, const CLI::Option& option) {
  std::vector<std::string> patterns;
  for (const std::string& name : names_of(option)) patterns.push_back(subcommand.get_name() + ':' + name);
  const std::string call = bash_call(candidates_of(option));
  return "    " + join(patterns, " | ") + ") " + (call.empty() ? "" : call + "; ") + "return ;;\n";
}

std::string bash_option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : named_options_of(app)) {
    for (const std::string& name : names_of(*option)) names.push_back(name);
  }
  return join(names);
}

/// The candidates if no option waits for its value: options after a dash, otherwise the arguments.
std::string bash_word_rule(const std::string& subcommand, const std::string& options,
                           const std::string& argument_call) {
  return "    " + subcommand + ":-*) _whittle_words '" + options + "' ;;\n    " + subcommand + ":*) " +
         (argument_call.empty() ? "" : argument_call + " ") + ";;\n";
}

}  // namespace

std::string bash_script(const CLI::App& app, const std::string& program) {
  std::string helpers = bash_helpers;
  const std::string place = "@PATTERNS@";
  helpers.replace(helpers.find(place), place.size(), bash_patterns());
  std::string script =
      "# Completion of whittle for bash 4 and later. Made by 'whittle completion bash' of " + program + ".\n";
  script += helpers;
  std::vector<std::string> names;
  std::string words;
  for (const CLI::App* sub : subcommands_of(app)) {
    names.push_back(sub->get_name());
    for (const CLI::Option* option : named_options_of(*sub)) {
      if (takes_value(*option)) script += bash_value_rule(*sub, *option);
    }
    const std::vector<const CLI::Option*> arguments = arguments_of(*sub);
    // Where arguments differ, the last one takes any file.
    words += bash_word_rule(sub->get_name(), bash_option_names(*sub),
                            arguments.empty() ? "" : bash_call(candidates_of(*arguments.back())));
  }
  script += "  esac\n  case $subcommand:$cur in\n" + words;
  script += bash_word_rule("help", "", "_whittle_words '" + join(names) + "'");
  script += bash_word_rule("", bash_option_names(app), "_whittle_words '" + join(names) + " help'");
  return script + "  esac\n}\n\ncomplete -F _whittle whittle\n";
}

}  // namespace whittle::app
