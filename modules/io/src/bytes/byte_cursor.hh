#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

#include "whittle/core/bytes/little_endian.hh"
#include "whittle/io/errors.hh"

namespace whittle::io {

/// A position in binary data that is held in memory.
class ByteCursor {
 public:
  /// \param bytes the whole file: messages count bytes from its beginning. \param start where to begin in it.
  /// \param name of the file, for messages.
  ByteCursor(std::string_view bytes, std::size_t start, std::endian order, std::string_view name)
      : bytes_(bytes), at_(start), order_(order), name_(name) {}

  std::size_t offset() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }
  const char* here() const { return bytes_.data() + at_; }
  std::endian order() const { return order_; }
  void set_order(std::endian order) { order_ = order; }

  /// \pre `count` bytes are left.
  void skip(std::size_t count) { at_ += count; }

  /// \param what names the missing data in the message. \throw ReadError if fewer than `count` bytes are left.
  void require(std::size_t count, std::string_view what) const {
    if (bytes_left() < count) fail("the file ends where " + std::string(what) + " should be; it is truncated");
  }

  /// Decodes a number and moves past it. \throw ReadError if the file ends before it.
  template <class Value>
  Value read(std::string_view what) {
    require(sizeof(Value), what);
    const Value value = load<Value>(here(), order_);
    skip(sizeof(Value));
    return value;
  }

  /// \throw ReadError that names a byte of the file.
  [[noreturn]] void fail(std::size_t offset, const std::string& problem) const {
    throw ReadError(std::string(name_), {.byte = offset}, problem);
  }
  [[noreturn]] void fail(const std::string& problem) const { fail(at_, problem); }

 private:
  std::string_view bytes_;
  std::size_t at_;
  std::endian order_;
  std::string_view name_;
};

}  // namespace whittle::io
