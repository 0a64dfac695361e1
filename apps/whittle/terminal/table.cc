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

/// Likewise, with the number of digits that `format` takes.
std::string formatted(const char* format, int digits, double x) {
  std::array<char, 48> text;
  const int size = std::snprintf(text.data(), text.size(), format, digits, x);
  return {text.data(), static_cast<std::size_t>(size)};
}

/// To four significant digits, but for rounding errors of x. \param x not negative
double rounded_up(double x) {
  if (!(x > 0)) return x;
  const double last_digit = std::pow(10, std::floor(std::log10(x)) - 3);
  return std::ceil(x / last_digit - 1e-9) * last_digit;
}

/// \param last_place of the last digit: -3 for thousandths, 0 for whole units
std::string coordinate_text(double x, int last_place) {
  const int n_decimals = std::max(0, -last_place);
  const double unit = std::pow(10, -n_decimals);
  if (std::abs(x) < unit / 2) return "0";
  // Numbers with very many zeros are shorter with an exponent.
  const int first_place = static_cast<int>(std::floor(std::log10(std::abs(x))));
  if (n_decimals > 8 || first_place > 14) return formatted("%.*g", std::clamp(first_place - last_place + 1, 4, 17), x);
  std::string digits = formatted("%.*f", n_decimals, x);
  if (n_decimals > 0) digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
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

std::string point_text(const Vec3& point, double extent) {
  const double size = extent > 0 ? extent : std::max(point.cwiseAbs().maxCoeff(), 1.0);
  const int last_place = static_cast<int>(std::floor(std::log10(size))) - 3;
  std::string text;
  for (const double x : point) text += (text.empty() ? "" : " ") + coordinate_text(x, last_place);
  return text;
}

std::string percent(double share) { return significant(100 * share) + " %"; }

std::string length_text(double length, double diagonal) {
  return significant(length) + " (" + percent(length / diagonal) + ")";
}

std::string length_text_rounded_up(double length, double diagonal) {
  return significant(rounded_up(length)) + " (" + significant(rounded_up(100 * length / diagonal)) + " %)";
}

std::string seconds_text(double seconds) { return formatted("%.3f s", seconds); }

std::string yes_no(bool value) { return value ? "yes" : "no"; }

std::string counted(std::uint64_t n, const std::string& singular, const std::string& plural) {
  return std::to_string(n) + ' ' + (n == 1 ? singular : plural);
}

std::string faces_text(std::uint64_t n) { return counted(n, "face", "faces"); }

std::string vertices_text(std::uint64_t n) { return counted(n, "vertex", "vertices"); }

}  // namespace whittle::app
