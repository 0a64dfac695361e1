#include "terminal/table.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace whittle::app {
namespace {

std::string formatted(const char* format, double x) {
  std::array<char, 48> text;
  const int size = std::snprintf(text.data(), text.size(), format, x);
  return {text.data(), static_cast<std::size_t>(size)};
}

/// To four significant digits, but for rounding errors of x. \param x not negative
double rounded_up(double x) {
  if (!(x > 0)) return x;
  const double last_digit = std::pow(10, std::floor(std::log10(x)) - 3);
  return std::ceil(x / last_digit - 1e-9) * last_digit;
}

}  // namespace

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

std::string significant(double x) { return formatted("%.4g", x); }

std::string percent(double share) { return significant(100 * share) + " %"; }

std::string length_text(double length, double diagonal) {
  return significant(length) + (diagonal > 0 ? " (" + percent(length / diagonal) + ")" : "");
}

std::string length_text_rounded_up(double length, double diagonal) {
  const std::string share = diagonal > 0 ? " (" + significant(rounded_up(100 * length / diagonal)) + " %)" : "";
  return significant(rounded_up(length)) + share;
}

std::string seconds_text(double seconds) { return formatted("%.3f s", seconds); }

std::string yes_no(bool value) { return value ? "yes" : "no"; }

std::string counted(std::uint64_t n, const std::string& singular, const std::string& plural) {
  return std::to_string(n) + ' ' + (n == 1 ? singular : plural);
}

std::string faces_text(std::uint64_t n) { return counted(n, "face", "faces"); }

std::string vertices_text(std::uint64_t n) { return counted(n, "vertex", "vertices"); }

}  // namespace whittle::app
