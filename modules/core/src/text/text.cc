#include "whittle/core/text/text.hh"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <system_error>

namespace whittle {
namespace {

std::string formatted(const char* format, double x) {
  std::array<char, 48> text;
  const int size = std::snprintf(text.data(), text.size(), format, x);
  return {text.data(), static_cast<std::size_t>(size)};
}

/// Rounds up to four significant digits; ignores rounding errors of x. \param x not negative
double rounded_up(double x) {
  if (!(x > 0 && std::isfinite(x))) return x;
  const std::string text = formatted("%.3e", x);
  const int exponent = std::stoi(text.substr(text.find('e') + 1));
  if (exponent < -300) return x;
  const double last_digit = std::stod("1e" + std::to_string(exponent - 3));
  return std::ceil(x / last_digit - 1e-9) * last_digit;
}

}  // namespace

std::string shortest(double x) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), x);
  return error == std::errc() ? std::string(text.data(), end) : std::string();
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

std::string counted(std::uint64_t n, const std::string& singular, const std::string& plural) {
  return std::to_string(n) + ' ' + (n == 1 ? singular : plural);
}

std::string faces_text(std::uint64_t n) { return counted(n, "face", "faces"); }

std::string vertices_text(std::uint64_t n) { return counted(n, "vertex", "vertices"); }

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string about(const std::string& name, const std::string& text) { return name + ": " + text; }

}  // namespace whittle
