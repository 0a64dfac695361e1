#include "whittle/pipeline/option.hh"

#include <algorithm>

namespace whittle {
namespace {

struct ValueText {
  std::string operator()(std::monostate) const { return "off"; }
  std::string operator()(bool value) const { return value ? "on" : "off"; }
  std::string operator()(std::uint64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return shortest(value); }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const std::vector<double>& values) const {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : ",") + shortest(value);
    return text.empty() ? "none" : text;
  }
};

Length above_zero(std::string_view text) {
  const Length length = parse_length(text, "E");
  if (!(length.value > 0)) throw std::invalid_argument("'" + std::string(text) + "' is not above 0");
  return length;
}

std::optional<std::vector<std::string>> parse_names(std::string_view text) {
  if (text == "auto") return std::nullopt;
  std::vector<std::string> names;
  if (text == "none") return names;
  for (const std::string_view name : parts_of(text)) {
    if (name.empty()) throw std::invalid_argument("a name is empty");
    names.emplace_back(name);
  }
  return names;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text.empty() ? "none" : text;
}

/// Words of the refusal where both are given.
std::string conflict_text(const std::string& own, const std::string& other, const std::string& why) {
  return own + " doesn't go with " + other + ": " + why;
}

/// Words of the warning that an option is idle. \p how is "without" or "with".
std::string idle_text(const std::string& own, std::string_view how, const std::string& other) {
  return "'" + own + "' does nothing " + std::string(how) + " '" + other + "'";
}

}  // namespace

std::string to_string(const OptionValue& value) { return std::visit(ValueText{}, value); }

std::string long_name(const OptionRow& row) {
  const std::size_t begin = row.names.find("--");
  return begin == std::string::npos ? row.names : row.names.substr(begin);
}

std::string side_of(const OptionRow& row, const std::string& value) {
  return value.empty() ? long_name(row) : long_name(row) + ' ' + value;
}

const OptionRow* find_row(std::span<const OptionRow> rows, std::string_view name) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const OptionRow& row) { return long_name(row) == name; });
  return found == rows.end() ? nullptr : &*found;
}

void append(OptionRows& rows, OptionRows more) {
  rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::string find_conflict(std::span<const OptionRow> rows, const IsGiven& is_given) {
  for (const OptionRow& row : rows) {
    for (const auto& [value, other, why] : row.conflicts) {
      const std::string own = side_of(row, value);
      if (is_given(own) && is_given(other)) return conflict_text(own, other, why);
    }
  }
  return {};
}

std::vector<std::string> find_idle(std::span<const OptionRow> rows, const IsGiven& is_given) {
  std::vector<std::string> sentences;
  for (const OptionRow& row : rows) {
    for (const auto& [value, without, with] : row.idle) {
      const std::string own = side_of(row, value);
      if (!is_given(own)) continue;
      const bool is_lonely = !without.empty() && std::none_of(without.begin(), without.end(), is_given);
      if (is_lonely) sentences.push_back(idle_text(own, "without", without.front()));
      if (!with.empty() && is_given(with)) sentences.push_back(idle_text(own, "with", with));
    }
  }
  return sentences;
}

OptionAccess flag(bool& target, bool value) {
  const auto set = [&target, value](std::string_view text) {
    if (!text.empty() && text != "on" && text != "off") {
      throw std::invalid_argument("'" + std::string(text) + "' is none of on|off");
    }
    target = (text == "off") != value;
  };
  return {"", set, [&target, value] { return OptionValue(target == value); }};
}

OptionAccess number_or_off(std::optional<double>& target, const Range& range, const std::string& meta, double off) {
  const auto set = [&target, range, meta, off](std::string_view text) {
    const double value = parse_number(text, range, meta);
    target = value == off ? std::nullopt : std::optional(value);
  };
  return {meta, set, [&target, off] { return OptionValue(target.value_or(off)); }};
}

OptionAccess length_above_zero(std::optional<Length>& target) { return parsed(target, "E", above_zero); }

OptionAccess automatic_length(AutomaticLength& target) {
  return parsed(target, "T|auto", [](std::string_view text) { return parse_automatic_length(text, "T"); });
}

OptionAccess texts(std::vector<std::string>& target) {
  return {"", [&target](std::string_view text) { target.emplace_back(text); },
          [&target] { return OptionValue(joined(target)); }};
}

OptionAccess names(std::optional<std::vector<std::string>>& target) {
  return {"auto|none|NAME,...", [&target](std::string_view text) { target = parse_names(text); },
          [&target] { return OptionValue(target ? joined(*target) : "auto"); }};
}

}  // namespace whittle
