#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "whittle/core/bytes/little_endian.hh"
#include "whittle/progressive/recording.hh"

namespace whittle::progressive {

/// Numbers as bytes, the lowest byte first.
class ByteWriter {
 public:
  template <class Number>
  void number(Number value) {
    append_little_endian(bytes_, value);
  }
  /// Seven bits a byte, the lowest first. A byte of 128 or more says that another follows.
  void count(std::uint64_t value) {
    for (; value >= 128; value >>= 7) bytes_.push_back(static_cast<char>(value | 128));
    bytes_.push_back(static_cast<char>(value));
  }
  /// 0, −1, 1, −2, … as 0, 1, 2, 3, …
  void difference(std::int64_t value) {
    count((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  void text(std::string_view text) { bytes_ += text; }
  std::string& bytes() { return bytes_; }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Number>
  Number number() {
    return load_little_endian<Number>(text(sizeof(Number)).data());
  }
  std::uint64_t count() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
      const auto byte = number<std::uint8_t>();
      value |= std::uint64_t{byte & 127U} << shift;
      if (byte < 128) return value;
    }
    throw RecordingError("a number has too many bytes");
  }
  std::int64_t difference() {
    const std::uint64_t value = count();
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  /// A number that follows another one. \throw RecordingError if it isn't below `end`
  Index index_after(Index last, std::uint64_t end) {
    const std::uint64_t value = static_cast<std::uint64_t>(last) + static_cast<std::uint64_t>(difference());
    if (value >= end) throw RecordingError("a vertex or face number is out of range");
    return static_cast<Index>(value);
  }
  std::string_view text(std::size_t n) {
    if (n > bytes_.size()) throw RecordingError("a part of it ends too soon");
    const std::string_view text = bytes_.substr(0, n);
    bytes_.remove_prefix(n);
    return text;
  }
  bool is_at_end() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

}  // namespace whittle::progressive
