#pragma once

#include <string>
#include <utility>
#include <vector>

/// Reading what the help prints and what the pages of docs/user have.
namespace whittle::test {

/// One option, without line breaks and markup.
struct OptionText {
  std::string name;      ///< "-r, --ratio R"
  std::string standard;  ///< "0.3", "off", "required"; empty where there is no such thing
  std::string meaning;
};

std::vector<std::string> lines_of(const std::string& text);
std::vector<std::string> words_of(const std::string& text);

/// The options a help text lists, without the arguments.
std::vector<OptionText> options_of_help(const std::string& help);
/// The rows of a page's tables under the heading "| option | default | meaning |".
std::vector<OptionText> options_of_page(const std::string& page);
/// The first two cells of a page's table under the heading "| option | does not go with | why |".
std::vector<std::pair<std::string, std::string>> conflicts_of_page(const std::string& page);

/// As such a table, for comparing and for copying.
std::string table_of(const std::vector<OptionText>& options);

}  // namespace whittle::test
