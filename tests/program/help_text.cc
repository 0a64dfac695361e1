#include "program/help_text.hh"

#include <sstream>

namespace whittle::test {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Moves "(default: x)" or "(required)" from the end of the meaning to `standard`.
void split_standard(OptionText& option) {
  const std::string opening = " (default: ";
  const std::string required = " (required)";
  std::string& meaning = option.meaning;
  if (meaning.ends_with(required)) {
    option.standard = "required";
    meaning.erase(meaning.size() - required.size());
  } else if (const std::size_t at = meaning.rfind(opening); at != std::string::npos && meaning.back() == ')') {
    option.standard = meaning.substr(at + opening.size());
    option.standard.pop_back();
    meaning.erase(at);
  }
}

/// The cells of a row of a Markdown table, without backquotes and with "\|" as "|".
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::string cell;
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i] == '\\' && i + 1 < row.size() && row[i + 1] == '|') {
      cell += row[++i];
    } else if (row[i] == '|') {
      cells.push_back(trimmed(cell));
      cell.clear();
    } else if (row[i] != '`') {
      cell += row[i];
    }
  }
  return cells;
}

/// The rows of all tables with this heading.
std::vector<std::vector<std::string>> rows_under(const std::string& page, const std::string& heading) {
  std::vector<std::vector<std::string>> rows;
  bool inside = false;
  for (const std::string& line : lines_of(page)) {
    if (line == heading) {
      inside = true;
    } else if (line.empty() || line.front() != '|') {
      inside = false;
    } else if (inside && line.rfind("|-", 0) != 0) {
      rows.push_back(cells_of(line));
    }
  }
  return rows;
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|') result += '\\';
    result += c;
  }
  return result;
}

}  // namespace

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::vector<OptionText> options_of_help(const std::string& help) {
  std::vector<OptionText> options;
  for (const std::string& line : lines_of(help)) {
    const bool begins = line.rfind("  -", 0) == 0;
    const bool goes_on = !options.empty() && line.rfind("      ", 0) == 0;
    if (line.rfind("Examples:", 0) == 0) break;
    if (begins) {
      const std::size_t gap = line.find("  ", 2);
      options.push_back({trimmed(line.substr(0, gap)), "", gap == std::string::npos ? "" : trimmed(line.substr(gap))});
    } else if (goes_on) {
      std::string& meaning = options.back().meaning;
      if (!meaning.empty()) meaning += ' ';
      meaning += trimmed(line);
    }
  }
  for (OptionText& option : options) split_standard(option);
  return options;
}

std::vector<OptionText> options_of_page(const std::string& page) {
  std::vector<OptionText> options;
  for (const auto& cells : rows_under(page, "| option | default | meaning |")) {
    options.push_back({cells.at(0), cells.at(1), cells.at(2)});
  }
  return options;
}

std::vector<std::pair<std::string, std::string>> conflicts_of_page(const std::string& page) {
  std::vector<std::pair<std::string, std::string>> conflicts;
  for (const auto& cells : rows_under(page, "| option | does not go with | why |")) {
    conflicts.emplace_back(cells.at(0), cells.at(1));
  }
  return conflicts;
}

std::string table_of(const std::vector<OptionText>& options) {
  std::string table = "| option | default | meaning |\n|-|-|-|\n";
  for (const OptionText& option : options) {
    for (const std::string& cell : {'`' + option.name + '`', option.standard, option.meaning}) {
      table += "| " + escaped(cell) + ' ';
    }
    table += "|\n";
  }
  return table;
}

}  // namespace whittle::test
