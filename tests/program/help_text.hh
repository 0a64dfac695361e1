#pragma once

#include <string>
#include <utility>
#include <vector>

/// Reads options from the help text, and options and keys of reports from the pages of docs/user.
namespace whittle::test {

/// One option, without line breaks and markup.
struct OptionText {
  std::string name;      ///< "-r, --ratio R"
  std::string standard;  ///< default: "0.3", "off", "required"; empty if there is none
  std::string meaning;
};

/// A row of the table of a report's keys: one key or several of the same kind.
struct KeyText {
  std::vector<std::string> keys;  ///< "input.vertices", "input.faces"; on the page "input.{vertices,faces}"
  std::string type;               ///< "integer", "number or null"
  std::string meaning;
  std::string when;  ///< "always", or when it is there
};

std::vector<std::string> lines_of(const std::string& text);
std::vector<std::string> words_of(const std::string& text);

/// The subcommands in the help of the whole program.
std::vector<std::string> subcommands_of_help(const std::string& help);
/// Those with a page of their own, docs/user/NAME.md: all but `completion` and `man`, which shell.md describes.
std::vector<std::string> subcommands_with_pages(const std::string& help);
/// The arguments in the help of a subcommand: "IN", "OUT".
std::vector<std::string> arguments_of_help(const std::string& help);
/// The names of an option, its value left out: "-r", "--ratio".
std::vector<std::string> names_of(const OptionText& option);
/// The options in a help text; positional arguments are left out.
std::vector<OptionText> options_of_help(const std::string& help);
/// Those of one group: "Targets" of "Targets (at least one):".
std::vector<OptionText> options_of_group(const std::string& help, const std::string& group);
/// The rows of a page's tables under the heading "| option | default | meaning |".
std::vector<OptionText> options_of_page(const std::string& page);
/// The first two cells of a page's table under the heading "| option | does not go with | why |".
std::vector<std::pair<std::string, std::string>> conflicts_of_page(const std::string& page);
/// The rows of a page's tables under the heading "| key | type | what it is | when |".
std::vector<KeyText> keys_of_page(const std::string& page);

/// The options as a table in that form, for comparing.
std::string table_of(const std::vector<OptionText>& options);
/// The same as pages have it, without blanks around cells.
std::string short_table_of(const std::vector<OptionText>& options);

}  // namespace whittle::test
