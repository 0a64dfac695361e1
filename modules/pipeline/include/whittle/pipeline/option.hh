#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "whittle/engine/refusals.hh"
#include "whittle/pipeline/values.hh"

// Options as data: one row an option. What parses, explains, reports, completes and checks options is a loop over rows,
// and so are interfaces in other languages.

namespace whittle {

/// The value of an option, as reports have it. Nothing where it is off.
using OptionValue = std::variant<std::monostate, bool, std::uint64_t, double, std::string, std::vector<double>>;

/// As on a command line: "on", "off", "0.5", "auto".
std::string to_string(const OptionValue& value);

/// Reads and tells a value. It refers to the request that the row was made for.
struct OptionAccess {
  std::string meta;  ///< what stands for the value in help: "R", "keep|free"; empty for a flag, which takes none
  std::function<void(std::string_view)> set;  ///< \throw std::invalid_argument that says what is valid
  std::function<OptionValue()> get;
};

/// Another option, or a value of one, that a row's option doesn't go with.
struct OptionConflict {
  std::string value{};  ///< of the row's option; empty = any
  std::string other;    ///< "--threshold", "--boundary free"
  std::string why;
};

/// When an option does nothing.
struct OptionIdle {
  std::string value{};                 ///< of the row's option; empty = any
  std::vector<std::string> without{};  ///< without each of these; or empty
  std::string with{};                  ///< with this; or empty
};

/// What an option does against a reason to refuse pairs.
struct OptionLift {
  Refusal reason;
  std::string value;    ///< with which the option refuses nothing for the reason
  std::string cause{};  ///< the value with which it does; empty = each other
};

/// Everything that is said of an option.
struct OptionRow {
  std::string names;  ///< "-r,--ratio"; "IN" for an argument, which has no other name
  OptionAccess access{};
  std::string group{};
  std::string help{};
  std::string standard{};  ///< the default, as help has it; empty = what `access` tells when the row is listed
  std::string key{};       ///< in reports; empty = it isn't reported
  std::function<OptionValue()> reported{};  ///< in reports, where it isn't what `access` tells
  std::vector<OptionConflict> conflicts{};
  std::vector<OptionIdle> idle{};
  std::optional<OptionLift> lift{};
  /// The value that only our own decimater knows, and no `Request::decimater`; empty = any. Nothing if all know it.
  std::optional<std::string> own_decimater{};
  bool is_required = false;
  bool takes_several = false;  ///< an argument that may be given more than once
};
using OptionRows = std::vector<OptionRow>;

/// "--ratio" of "-r,--ratio"; "IN"
std::string long_name(const OptionRow& row);
/// An option with a value of it, or any: "--boundary free", "--boundary"
std::string side_of(const OptionRow& row, const std::string& value);
/// The row of a long name; null if there is none.
const OptionRow* find_row(std::span<const OptionRow> rows, std::string_view name);
void append(OptionRows& rows, OptionRows more);

/// Whether an option, or a value of one, is given: "--threshold", "--boundary free".
using IsGiven = std::function<bool(const std::string& side)>;

/// "--threshold doesn't go with --isotropic: …" of the first two rows that don't; empty if all go together.
std::string find_conflict(std::span<const OptionRow> rows, const IsGiven& is_given);
/// "'--max-pairs' does nothing without '--threshold'": a sentence for each option that is given and does nothing.
std::vector<std::string> find_idle(std::span<const OptionRow> rows, const IsGiven& is_given);

// Ways to read and tell values ----------------------------------------------------------------------------------------

inline OptionValue told(bool value) { return value; }
inline OptionValue told(double value) { return value; }
inline OptionValue told(std::string value) { return value; }
inline OptionValue told(const Length& value) { return to_string(value); }
inline OptionValue told(const AutomaticLength& value) { return to_string(value); }
template <class T>
requires(std::is_unsigned_v<T> && !std::is_same_v<T, bool>) OptionValue told(T value) { return std::uint64_t{value}; }
template <class T>
OptionValue told(const std::optional<T>& value) {
  return value ? told(*value) : OptionValue{};
}

/// \param parse turns the text into a value for `target`, or throws std::invalid_argument
template <class T, class Parse>
OptionAccess parsed(T& target, std::string meta, Parse parse) {
  return {std::move(meta), [&target, parse](std::string_view text) { target = parse(text); },
          [&target] { return told(target); }};
}

/// \param value what the flag means
OptionAccess flag(bool& target, bool value = true);
/// \tparam T double, or an optional one
template <class T>
OptionAccess number(T& target, const Range& range, const std::string& meta) {
  return parsed(target, meta, [range, meta](std::string_view text) { return parse_number(text, range, meta); });
}
/// A number of which one, `off`, means none.
OptionAccess number_or_off(std::optional<double>& target, const Range& range, const std::string& meta, double off);
/// \tparam T an unsigned type, or an optional one
template <class T>
OptionAccess count(T& target, std::uint64_t low = 1, std::uint64_t high = std::numeric_limits<std::uint64_t>::max(),
                   const std::string& meta = "N") {
  return parsed(target, meta, [low, high](std::string_view text) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>(parse_count(text, low, high));
    } else {
      return T{static_cast<typename T::value_type>(parse_count(text, low, high))};
    }
  });
}
/// \tparam T double, or an optional one
template <class T>
OptionAccess ratio(T& target) {
  return parsed(target, "R", [](std::string_view text) { return parse_ratio(text); });
}
/// \tparam T Length, or an optional one
template <class T>
OptionAccess length(T& target, const std::string& meta) {
  return parsed(target, meta, [meta](std::string_view text) { return parse_length(text, meta); });
}
OptionAccess length_above_zero(std::optional<Length>& target);
OptionAccess automatic_length(AutomaticLength& target);
/// \tparam T std::string, or an optional one
template <class T>
OptionAccess text(T& target, std::string meta) {
  return parsed(target, std::move(meta), [](std::string_view given) { return std::string(given); });
}
/// Files, one after the other.
OptionAccess texts(std::vector<std::string>& target);

/// One of several words.
template <class E, std::size_t N>
OptionAccess choice(E& target, const std::array<Choice<E>, N>& choices) {
  const std::span<const Choice<E>> all(choices);
  return {words_of(all), [&target, all](std::string_view text) { target = parse_choice(text, all); },
          [&target, all] { return OptionValue(std::string(word_of(all, target))); }};
}
template <class E, std::size_t N>
OptionAccess choice(std::optional<E>& target, const std::array<Choice<E>, N>& choices) {
  const std::span<const Choice<E>> all(choices);
  return {words_of(all), [&target, all](std::string_view text) { target = parse_choice(text, all); },
          [&target, all] { return target ? OptionValue(std::string(word_of(all, *target))) : OptionValue{}; }};
}

/// Names with commas between, "auto" or "none". \param target empty = "auto"
OptionAccess names(std::optional<std::vector<std::string>>& target);

}  // namespace whittle
