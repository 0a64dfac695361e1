#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

// Words of a line of text, between blanks.

namespace whittle::io {

inline constexpr std::string_view blanks = " \t\r\v\f";

/// Without the blanks around it.
inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Removes the first word, and the blanks around the rest. \return the word
inline std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const std::string_view word = text.substr(0, end);
  text = trimmed(text.substr(end));
  return word;
}

/// Whether two words are equal but for upper and lower case. \param b in lower case
inline bool is_same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, char y) { return std::tolower(x) == y; });
}

}  // namespace whittle::io
