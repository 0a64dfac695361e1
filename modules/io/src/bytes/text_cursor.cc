#include "bytes/text_cursor.hh"

namespace whittle::io {

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

std::string TextCursor::rest_of_line() {
  std::string text;
  for (skip_blanks(); !at_line_end();) {
    if (is_continuation()) {
      skip_blanks();
      text += ' ';
    } else {
      text += *at_++;
    }
  }
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  return text;
}

std::uint64_t TextCursor::line_of(const char* where) const {
  std::uint64_t line = 1;
  for (const char* c = begin_; c != where; ++c) {
    const bool lone_return = *c == '\r' && (c + 1 == end_ || c[1] != '\n');
    if (*c == '\n' || lone_return) ++line;
  }
  return line;
}

std::string TextCursor::excerpt(const char* where) const {
  constexpr std::size_t longest = 24;
  TextCursor rest = *this;
  rest.at_ = where;
  const std::string_view token = rest.token();
  std::string text(token.substr(0, longest));
  for (char& c : text) {
    if (c < 0x20 || c > 0x7e) c = '?';  // UTF-8 too: the cut might go through a character.
  }
  return token.size() <= longest ? text : text + "...";
}

void TextCursor::fail_too_large(const char* where, std::string_view what) const {
  fail(where, std::string(what) + " is too large: " + excerpt(where));
}

void TextCursor::fail_token(const char* where, std::string_view what) const {
  TextCursor rest = *this;
  rest.at_ = where;
  rest.skip_blanks();
  if (rest.at_end()) fail(where, "the file ends where " + std::string(what) + " should be; it may be truncated");
  if (rest.at_line_end()) fail(where, "the line ends where " + std::string(what) + " should be");
  fail(where, std::string(what) + " expected, found \"" + excerpt(rest.at_) + '"');
}

}  // namespace whittle::io
