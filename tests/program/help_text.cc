#include "program/help_text.hh"

#include <algorithm>
#include <sstream>
#include <stdexcept>

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

/// "a.{b,c}" as "a.b", "a.c"; several braces give all combinations.
std::vector<std::string> without_braces(const std::string& key) {
  const std::size_t open = key.find('{');
  if (open == std::string::npos) return {key};
  const std::size_t close = key.find('}', open);
  std::vector<std::string> keys;
  std::istringstream names(key.substr(open + 1, close - open - 1));
  for (std::string name; std::getline(names, name, ',');) {
    for (const std::string& rest : without_braces(key.substr(close + 1))) {
      keys.push_back(key.substr(0, open) + name + rest);
    }
  }
  return keys;
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

namespace {

/// The first words of the rows below a title. Their other lines begin further to the right.
std::vector<std::string> names_below(const std::string& title, const std::string& help) {
  std::vector<std::string> names;
  bool is_inside = false;
  for (const std::string& line : lines_of(help)) {
    if (is_inside && line.empty()) break;
    if (is_inside && !line.starts_with("   ")) names.push_back(words_of(line).front());
    if (line == title) is_inside = true;
  }
  return names;
}

}  // namespace

std::vector<std::string> subcommands_of_help(const std::string& help) { return names_below("Subcommands:", help); }

std::vector<std::string> subcommands_with_pages(const std::string& help) {
  std::vector<std::string> names = subcommands_of_help(help);
  for (const char* name : {"completion", "man"}) {
    if (std::erase(names, name) != 1) throw std::runtime_error("the help doesn't list " + std::string(name));
  }
  return names;
}

std::vector<std::string> arguments_of_help(const std::string& help) { return names_below("Arguments:", help); }

std::vector<std::string> names_of(const OptionText& option) {
  std::vector<std::string> names;
  for (std::string word : words_of(option.name)) {
    if (word.front() != '-') continue;
    if (word.ends_with(',')) word.pop_back();
    names.push_back(word);
  }
  return names;
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

std::vector<OptionText> options_of_group(const std::string& help, const std::string& group) {
  std::string part;
  bool is_inside = false;
  for (const std::string& line : lines_of(help)) {
    const bool is_title = !line.empty() && line.front() != ' ' && line.back() == ':';
    if (is_title) is_inside = line.substr(0, std::min(line.find(" ("), line.size() - 1)) == group;
    if (is_inside) part += line + '\n';
  }
  return options_of_help(part);
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

std::vector<KeyText> keys_of_page(const std::string& page) {
  std::vector<KeyText> rows;
  for (const auto& cells : rows_under(page, "| key | type | what it is | when |")) {
    rows.push_back({{}, cells.at(1), cells.at(2), cells.at(3)});
    std::istringstream written(cells.at(0));
    for (std::string key; std::getline(written, key, ' ');) {
      if (key.ends_with(',')) key.pop_back();
      for (const std::string& each : without_braces(key)) rows.back().keys.push_back(each);
    }
  }
  return rows;
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

std::string short_table_of(const std::vector<OptionText>& options) {
  std::string table = "| option | default | meaning |\n|-|-|-|\n";
  for (const OptionText& option : options) {
    for (const std::string& cell : {'`' + option.name + '`', option.standard, option.meaning}) {
      table += '|' + escaped(cell);
    }
    table += "|\n";
  }
  return table;
}

}  // namespace whittle::test
