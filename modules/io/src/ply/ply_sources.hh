#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "bytes/byte_cursor.hh"
#include "bytes/text_cursor.hh"
#include "ply/ply_fixed_rows.hh"
#include "ply/ply_header.hh"

// Where the reader takes numbers from. A source knows the encoding.

namespace whittle::io {

/// Takes numbers from text.
class PlyTextSource {
 public:
  using Location = const char*;
  static constexpr bool has_fixed_sizes = false;  // Of numbers.

  explicit PlyTextSource(const TextCursor& cursor) : cursor_(cursor) {}

  Location location() const { return cursor_.position(); }
  [[noreturn]] void fail(Location location, const std::string& problem) const { cursor_.fail(location, problem); }

  // A digit and a separator. The last number of the file may lack the separator.
  static std::uint64_t least_bytes(const PlyProperty&) { return 2; }
  std::uint64_t bytes_left() const { return cursor_.bytes_left() + 1; }

  void begin_row() { cursor_.skip_space(); }
  void end_row() {
    cursor_.skip_blanks();
    if (!cursor_.at_line_end()) cursor_.fail("more numbers in a line than the header announces");
  }

  // A number declared as float is rounded to float, as in a binary file.
  double number(PlyType type, std::string_view what) {
    cursor_.skip_blanks();
    return type == PlyType::float32 ? static_cast<double>(cursor_.number<float>(what)) : cursor_.number<double>(what);
  }
  std::int64_t length(PlyType, std::string_view what) {
    cursor_.skip_blanks();
    return cursor_.whole_integer(what);
  }
  // Lists may go over several lines.
  std::int64_t entry(PlyType, std::string_view what) {
    cursor_.skip_space();
    return cursor_.whole_integer(what);
  }
  double list_number(PlyType type, std::string_view what) {
    cursor_.skip_space();
    return number(type, what);
  }
  void skip(PlyType type, std::uint64_t count, std::string_view what) {
    for (std::uint64_t i = 0; i < count; ++i) {
      cursor_.skip_space();
      number(type, what);
    }
  }
  void finish() {
    cursor_.skip_space();
    if (!cursor_.at_end()) cursor_.fail("the file goes on after what its header announces; its counts are wrong");
  }

 private:
  TextCursor cursor_;
};

/// Takes numbers from binary data.
class PlyBinarySource {
 public:
  using Location = std::size_t;
  static constexpr bool has_fixed_sizes = true;

  explicit PlyBinarySource(const ByteCursor& cursor) : cursor_(cursor) {}

  Location location() const { return cursor_.offset(); }
  [[noreturn]] void fail(Location location, const std::string& problem) const { cursor_.fail(location, problem); }

  static std::uint64_t least_bytes(const PlyProperty& property) {
    return size_of(property.count_type.value_or(property.type));
  }
  std::uint64_t bytes_left() const { return cursor_.bytes_left(); }

  void begin_row() {}
  void end_row() {}

  double number(PlyType type, std::string_view what) {
    return with_scalar_type(
        type, [&]<class Number>(Number) { return static_cast<double>(cursor_.template read<Number>(what)); });
  }
  std::int64_t length(PlyType type, std::string_view what) { return entry(type, what); }
  std::int64_t entry(PlyType type, std::string_view what) {
    if (type == PlyType::int32) return cursor_.read<std::int32_t>(what);
    if (type == PlyType::uint8) return cursor_.read<std::uint8_t>(what);
    const Location at = location();
    const double value = number(type, what);
    if (!(std::abs(value) < 9e15) || value != std::floor(value)) fail(at, std::string(what) + " is not whole");
    return static_cast<std::int64_t>(value);
  }
  double list_number(PlyType type, std::string_view what) { return number(type, what); }
  void skip(PlyType type, std::uint64_t count, std::string_view what) {
    cursor_.require(count * size_of(type), what);
    cursor_.skip(count * size_of(type));
  }
  // Rows of `size` bytes each, from here on.
  PlyRows rows(std::size_t size) const { return {cursor_.here(), size, cursor_.order()}; }
  // \pre `bytes` bytes are left.
  void skip_bytes(std::size_t bytes) { cursor_.skip(bytes); }

  // Padding at the end is harmless. Anything else contradicts the header.
  void finish() {
    for (std::size_t i = 0; i < cursor_.bytes_left(); ++i) {
      const char c = cursor_.here()[i];
      if (c != '\0' && c != '\n' && c != '\r' && c != ' ') {
        cursor_.fail("the file goes on after what its header announces; its counts are wrong");
      }
    }
  }

 private:
  ByteCursor cursor_;
};

}  // namespace whittle::io
