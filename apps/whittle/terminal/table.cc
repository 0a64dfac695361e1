#include "terminal/table.hh"

#include <algorithm>
#include <utility>

namespace whittle::app {

void Table::add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

std::string Table::text() const {
  std::vector<std::size_t> widths;
  for (const auto& row : rows_) {
    if (widths.size() < row.size()) widths.resize(row.size(), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string padding(widths[i] - row[i].size(), ' ');
      line += i == 0 ? row[i] + padding : "  " + padding + row[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string grouped(std::uint64_t n) {
  constexpr std::size_t group = 3;
  std::string digits = std::to_string(n);
  for (std::size_t i = digits.size(); i > group; i -= group) digits.insert(i - group, ",");
  return digits;
}

std::string yes_no(bool value) { return value ? "yes" : "no"; }

}  // namespace whittle::app
