#include "shell/man_page.hh"

#include <sstream>

#include "options/help.hh"
#include "shell/candidates.hh"

// The language of manual pages: lines that begin with a dot are requests. man(7), groff_man(7).

namespace whittle::app {
namespace {

/// Text as it is: no request, no special character.
std::string roff(const std::string& text) {
  std::string result;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && c == '.') result += "\\&";
    begins_line = c == '\n';
    switch (c) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      case '\'':
        result += "\\(aq";
        break;
      case '`':
        result += "\\(ga";
        break;
      case '^':
        result += "\\(ha";
        break;
      case '~':
        result += "\\(ti";
        break;
      default:
        result += c;
    }
  }
  return result;
}

/// "whittle simplify IN -o OUT TARGET... [OPTION]..."
std::string man_call(const CLI::App& sub) {
  const std::string usage = usage_of(sub);
  return ".B whittle " + sub.get_name() + '\n' + (usage.empty() ? "" : roff(usage) + '\n');
}

/// Lines that stay as they are.
std::string verbatim(const std::string& lines) { return ".PP\n.nf\n" + roff(lines) + "\n.fi\n"; }

std::string paragraph(const std::string& text) { return ".PP\n" + roff(text) + '\n'; }

std::string man_entry(const std::string& name, const std::string& meaning) {
  return ".TP\n\\fB" + roff(name) + "\\fR\n" + roff(meaning) + '\n';
}

std::string man_options(const OptionGroup& group) {
  std::string text = ".PP\n\\fI" + roff(group.title) + "\\fR\n";
  for (const CLI::Option* option : group.options) text += man_entry(shown_name(*option), shown_description(*option));
  return text;
}

std::string man_subcommand(const CLI::App& sub) {
  std::string text = ".SS " + roff(sub.get_name()) + '\n' + man_call(sub) + paragraph(sub.get_description());
  for (const OptionGroup& group : option_groups(sub)) {
    if (group.title != common_group) text += man_options(group);
  }
  return text + verbatim(sub.get_footer());
}

/// The options that every subcommand has.
std::string man_common_options(const CLI::App& sub) {
  std::string text;
  for (const OptionGroup& group : option_groups(sub)) {
    if (group.title != common_group) continue;
    for (const CLI::Option* option : group.options) text += man_entry(shown_name(*option), shown_description(*option));
  }
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& program) {
  const std::vector<const CLI::App*> subs = subcommands_of(app);
  std::string text = ".TH WHITTLE 1 \"\" \"" + roff(program) + "\" \"User Commands\"\n";
  text += ".nh\n.ad l\n";  // no hyphens in names, no wide gaps
  text += ".SH NAME\nwhittle \\- make triangle meshes smaller and keep their shape\n.SH SYNOPSIS\n";
  for (const CLI::App* sub : subs) text += man_call(*sub) + ".br\n";
  text += ".B whittle help\n[SUBCOMMAND]\n.SH DESCRIPTION\n" + roff(app.get_description()) + '\n';
  text += paragraph("Data goes to standard output, messages to standard error. '-' is standard input or output.");
  for (const OptionGroup& group : option_groups(app)) text += man_options(group);
  text += ".SH SUBCOMMANDS\n";
  for (const CLI::App* sub : subs) text += man_subcommand(*sub);
  text += ".SH COMMON OPTIONS\nEvery subcommand that reads a mesh has these.\n" + man_common_options(*subs.front());
  text += ".SH EXIT STATUS\n" + roff(exit_statuses) + '\n';
  text += ".SH ENVIRONMENT\n" +
          man_entry("NO_COLOR", "If it is set and not empty, nothing is in colour, unless --color always is given.");
  return text + man_entry("TERM", "If it is not set, or 'dumb', no progress bar is drawn, and nothing is in colour.");
}

}  // namespace whittle::app
