#pragma once

#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "whittle/io/errors.hh"

namespace whittle::io {

/// Text without the byte order mark that some editors put before UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// A position in a text file that is held in memory. A line ends with LF, CR LF or CR. A backslash before the line
/// break continues the line. Lines are counted only when an error needs a line number.
class TextCursor {
 public:
  TextCursor(std::string_view text, std::string_view name)
      : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), name_(name) {}

  /// A cursor on a range of bytes of the text. Lines are counted from the beginning of the whole.
  TextCursor part(std::size_t begin, std::size_t end) const {
    TextCursor cursor = *this;
    cursor.at_ = begin_ + begin;
    cursor.end_ = begin_ + end;
    return cursor;
  }

  const char* position() const { return at_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
  bool at_end() const { return at_ == end_; }

  /// The character here. \pre not at the end of the file.
  char peek() const { return *at_; }
  bool at_line_end() const { return at_ == end_ || *at_ == '\n' || *at_ == '\r'; }
  /// Whether it is at a blank, or at the end of the line or of the file.
  bool at_token_end() const { return at_line_end() || is_blank(*at_) || is_continuation(); }

  /// Moves over blanks within the line.
  void skip_blanks() {
    while (at_ != end_) {
      if (is_blank(*at_)) {
        ++at_;
      } else if (*at_ == '\\' && is_continuation()) {
        ++at_;
        skip_line_break();
      } else {
        return;
      }
    }
  }

  /// Moves over blanks, line breaks, and comments that start with `comment` (0: there are no comments).
  void skip_space(char comment = 0) {
    while (skip_blanks(), at_ != end_) {
      if (at_line_end()) {
        skip_line_break();
      } else if (comment != 0 && *at_ == comment) {
        skip_rest_of_line();
      } else {
        return;
      }
    }
  }

  /// Moves to the line break, or to the end of the file.
  void skip_rest_of_line() {
    while (!at_line_end()) ++at_;
  }

  /// Moves to the beginning of the next line.
  void next_line() {
    skip_rest_of_line();
    skip_line_break();
  }

  /// Moves over the characters up to a blank or the end of the line, and returns them. Empty at the end of a line.
  std::string_view token() {
    const char* const first = at_;
    while (!at_token_end()) ++at_;
    return {first, static_cast<std::size_t>(at_ - first)};
  }

  /// Moves to the end of the line, and returns the rest of it, without blanks around. A continuation becomes a blank.
  std::string rest_of_line();

  /// Moves to a byte of the text. \pre not beyond its end.
  void skip_to(std::size_t offset) { at_ = begin_ + offset; }

  /// Moves over this character if it is the next one. \return whether it was.
  bool skip_if(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  /// Reads a real number that ends at a blank or line end. Infinities and NaN are returned as such.
  /// \param what names the number in messages. \throw ReadError if there is none.
  template <class Real>
  Real number(std::string_view what) {
    const char* const first = at_;
    const char* const digits = first != end_ && *first == '+' ? first + 1 : first;  // from_chars refuses a plus sign
    Real value{};
    const auto [last, error] = fast_float::from_chars(digits, end_, value);
    if (error == std::errc::invalid_argument) fail_token(first, what);
    at_ = last;
    if (!at_token_end()) fail_token(first, what);
    return value;
  }

  /// Likewise, but infinities and NaN are refused.
  template <class Real>
  Real finite_number(std::string_view what) {
    const char* const first = at_;
    const Real value = number<Real>(what);
    if (!std::isfinite(value)) fail(first, std::string(what) + " is not finite: \"" + excerpt(first) + '"');
    return value;
  }

  /// Reads a whole number; any text may follow. \throw ReadError if there is none.
  std::int64_t integer(std::string_view what) {
    const char* const first = at_;
    const char* const digits = first != end_ && *first == '+' ? first + 1 : first;
    std::int64_t value = 0;
    const auto [last, error] = std::from_chars(digits, end_, value);
    if (error == std::errc::result_out_of_range) fail_too_large(first, what);
    if (error != std::errc{}) fail_token(first, what);
    at_ = last;
    return value;
  }

  /// Likewise, but it must end at a blank or line end.
  std::int64_t whole_integer(std::string_view what) {
    const char* const first = at_;
    const std::int64_t value = integer(what);
    if (!at_token_end()) fail_token(first, what);
    return value;
  }

  /// \throw ReadError that names the line of `where`.
  [[noreturn]] void fail(const char* where, const std::string& problem) const {
    throw ReadError(std::string(name_), {.line = line_of(where)}, problem);
  }
  [[noreturn]] void fail(const std::string& problem) const { fail(at_, problem); }

  /// \throw ReadError: `what` was expected at `where`, with the text found instead.
  [[noreturn]] void fail_token(const char* where, std::string_view what) const;
  /// \throw ReadError: the number at `where` doesn't fit.
  [[noreturn]] void fail_too_large(const char* where, std::string_view what) const;

  std::uint64_t line_of(const char* where) const;

  /// The token at `where` for messages: shortened, printable characters only.
  std::string excerpt(const char* where) const;

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

  bool is_continuation() const { return *at_ == '\\' && at_ + 1 != end_ && (at_[1] == '\n' || at_[1] == '\r'); }

  void skip_line_break() {
    if (at_ != end_ && *at_ == '\r') {
      ++at_;
      if (at_ != end_ && *at_ == '\n') ++at_;
    } else if (at_ != end_ && *at_ == '\n') {
      ++at_;
    }
  }

  const char* begin_;
  const char* at_;
  const char* end_;
  std::string_view name_;
};

}  // namespace whittle::io
