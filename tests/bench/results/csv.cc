#include "bench/results/csv.hh"

#include <array>
#include <cstdio>

namespace whittle::bench {
namespace {

/// Quoted if CSV needs it.
std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

std::string formatted(const char* format, double value) {
  std::array<char, 64> text{};
  const int size = std::snprintf(text.data(), text.size(), format, value);
  return {text.data(), static_cast<std::size_t>(size)};
}

std::string text_or_dash(const std::optional<double>& value, const char* format) {
  return value ? formatted(format, *value) : "-";
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (!line.empty()) line += ',';
    line += csv_cell(cell);
  }
  return line + '\n';
}

std::string csv_number(const std::optional<double>& value) { return value ? formatted("%.6g", *value) : ""; }

}  // namespace whittle::bench
