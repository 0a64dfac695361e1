#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <memory>
#include <ostream>
#include <string_view>

#include "whittle/core/bytes/little_endian.hh"

namespace whittle::io {

/// Formats numbers into a block of memory and writes full blocks to a stream. Errors show in the stream's state, once
/// `flush` was called.
class ByteSink {
 public:
  explicit ByteSink(std::ostream& out) : out_(out), block_(std::make_unique_for_overwrite<char[]>(capacity)) {}

  ByteSink& operator<<(std::string_view text) {
    for (; text.size() > capacity; text.remove_prefix(capacity)) put(text.data(), capacity);
    put(text.data(), text.size());
    return *this;
  }

  /// Writes the shortest text that reads back as the same number of the same type. −0 keeps its sign.
  template <class Number>
  ByteSink& number(Number value) {
    constexpr std::size_t longest = 32;
    make_room(longest);
    char* const at = block_.get() + used_;
    used_ += static_cast<std::size_t>(std::to_chars(at, at + longest, value).ptr - at);
    return *this;
  }

  /// Writes the bytes of a number, lowest first.
  template <class Number>
  ByteSink& little_endian(Number value) {
    std::array<char, sizeof(Number)> bytes;
    store_little_endian(value, bytes.data());
    put(bytes.data(), bytes.size());
    return *this;
  }

  void flush() {
    out_.write(block_.get(), static_cast<std::streamsize>(used_));
    used_ = 0;
    out_.flush();
  }

 private:
  static constexpr std::size_t capacity = std::size_t{1} << 18;

  void make_room(std::size_t bytes) {
    if (capacity - used_ >= bytes) return;
    out_.write(block_.get(), static_cast<std::streamsize>(used_));
    used_ = 0;
  }

  void put(const char* bytes, std::size_t count) {
    make_room(count);
    std::memcpy(block_.get() + used_, bytes, count);
    used_ += count;
  }

  std::ostream& out_;
  std::unique_ptr<char[]> block_;
  std::size_t used_ = 0;
};

}  // namespace whittle::io
