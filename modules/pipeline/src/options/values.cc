#include "whittle/pipeline/values.hh"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

namespace whittle {
namespace {

constexpr std::string_view automatic = "auto";

std::invalid_argument not_valid(std::string_view text, const std::string& expected) {
  return std::invalid_argument("'" + std::string(text) + "' is not " + expected);
}

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = fast_float::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::string to_string(const Range& range, std::string_view name) {
  const std::string x(name);
  const bool bounded = range.high < std::numeric_limits<double>::infinity();
  if (!bounded) return x + (range.low_included ? " >= " : " > ") + shortest(range.low);
  return shortest(range.low) + (range.low_included ? " <= " : " < ") + x + (range.high_included ? " <= " : " < ") +
         shortest(range.high);
}

double parse_number(std::string_view text, const Range& range, std::string_view name) {
  const std::optional<double> value = number(text);
  if (!value || !range.contains(*value)) throw not_valid(text, "a number with " + to_string(range, name));
  return *value;
}

Length parse_length(std::string_view text, std::string_view name) {
  const bool is_relative = text.ends_with('%');
  const std::optional<double> value = number(is_relative ? text.substr(0, text.size() - 1) : text);
  if (!value || *value < 0) {
    throw not_valid(text, "a length " + std::string(name) + " >= 0 in model units, or a percentage of the diagonal");
  }
  return {is_relative ? *value / 100 : *value, is_relative};
}

std::string to_string(const Length& length) {
  return length.is_relative ? shortest(length.value * 100) + '%' : shortest(length.value);
}

AutomaticLength parse_automatic_length(std::string_view text, std::string_view name) {
  if (text == automatic) return {true, {}};
  try {
    return {false, parse_length(text, name)};
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + ", or '" + std::string(automatic) + "'");
  }
}

std::string to_string(const AutomaticLength& length) {
  return length.is_automatic ? std::string(automatic) : to_string(length.length);
}

std::uint64_t parse_count(std::string_view text, std::uint64_t low, std::uint64_t high) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value < low || value > high) {
    const bool bounded = high < std::numeric_limits<std::uint64_t>::max();
    throw not_valid(text, "a whole number of at least " + std::to_string(low) +
                              (bounded ? " and at most " + std::to_string(high) : ""));
  }
  return value;
}

double parse_ratio(std::string_view text) {
  const bool percent = text.ends_with('%');
  const std::optional<double> value = number(percent ? text.substr(0, text.size() - 1) : text);
  const double ratio = value.value_or(0) / (percent ? 100 : 1);
  if (!(ratio > 0 && ratio < 1)) {
    throw not_valid(text, "a share to keep: 0 < R < 1, or a percentage such as 30%");
  }
  return ratio;
}

std::uint64_t share_of(double ratio, std::uint64_t n) {
  const double product = ratio * static_cast<double>(n);
  // The ratio was rounded once when parsed (twice as a percentage), the product once: less than four half-ulps
  // together.
  return static_cast<std::uint64_t>(std::floor(product * (1 + 4 * std::numeric_limits<double>::epsilon())));
}

std::vector<std::string_view> parts_of(std::string_view list) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    parts.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace whittle
