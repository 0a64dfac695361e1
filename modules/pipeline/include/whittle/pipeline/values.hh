#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "whittle/core/text/text.hh"
#include "whittle/scene/length.hh"

// Parsers for the values of options. Each parses the whole text or throws std::invalid_argument. The message gives the
// problem and the valid values, but doesn't name the option.

namespace whittle {

/// An interval of finite numbers.
struct Range {
  double low;
  double high = std::numeric_limits<double>::infinity();
  bool low_included = true;
  bool high_included = true;

  bool contains(double x) const {
    return (low_included ? x >= low : x > low) && (high_included ? x <= high : x < high) &&
           x < std::numeric_limits<double>::infinity();
  }
};

/// "0 < X <= 180", "X >= 0". \param name printed in place of X
std::string to_string(const Range& range, std::string_view name);

double parse_number(std::string_view text, const Range& range, std::string_view name);

/// A whole number in [low, high], written in decimal digits.
std::uint64_t parse_count(std::string_view text, std::uint64_t low = 1,
                          std::uint64_t high = std::numeric_limits<std::uint64_t>::max());

/// At least 0: "0.5", or "1%" of the diagonal. \param name of the value, for the message
Length parse_length(std::string_view text, std::string_view name);

/// "0.5", "1%"
std::string to_string(const Length& length);

/// The values of `parse_length`, or "auto".
AutomaticLength parse_automatic_length(std::string_view text, std::string_view name);

/// "0.5", "1%", "auto"
std::string to_string(const AutomaticLength& length);

/// A share in (0, 1): "0.3" or "30%".
double parse_ratio(std::string_view text);

/// floor(ratio · n). A product that is a whole number except for rounding (0.29 · 100) counts as that number.
std::uint64_t share_of(double ratio, std::uint64_t n);

/// The parts of a comma-separated list; an empty text has one empty part.
std::vector<std::string_view> parts_of(std::string_view list);

/// A word of an option, and its value.
template <class E>
struct Choice {
  std::string_view word;
  E value;
};

template <class E>
std::string_view word_of(std::span<const Choice<E>> choices, E value) {
  for (const Choice<E>& choice : choices) {
    if (choice.value == value) return choice.word;
  }
  throw std::logic_error("a choice without a word");
}

/// "area|uniform|area-angle"
template <class E>
std::string words_of(std::span<const Choice<E>> choices) {
  std::string words;
  for (const Choice<E>& choice : choices) {
    if (!words.empty()) words += '|';
    words += choice.word;
  }
  return words;
}

template <class E>
E parse_choice(std::string_view text, std::span<const Choice<E>> choices) {
  for (const Choice<E>& choice : choices) {
    if (choice.word == text) return choice.value;
  }
  throw std::invalid_argument("'" + std::string(text) + "' is none of " + words_of(choices));
}

}  // namespace whittle
