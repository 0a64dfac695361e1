#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace whittle::test {

/// Turns the bytes of a fuzzer into numbers, from the front. After the last byte all are 0.
class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

  bool is_empty() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto first = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return first;
  }

  /// In [0, count); count in [1, 256].
  std::uint8_t below(unsigned count) { return static_cast<std::uint8_t>(byte() % count); }

  /// In [low, high].
  int whole(int low, int high) { return low + below(static_cast<unsigned>(high - low + 1)); }

  bool one_in(unsigned count) { return below(count) == count - 1; }

  /// One of 256 numbers from low to high, both included.
  double real(double low, double high) { return low + (high - low) * (byte() / 255.0); }

  std::uint64_t bits() {
    std::uint64_t value = 0;
    for (int i = 0; i < 8; ++i) value = value << 8 | byte();
    return value;
  }

  /// Any number at all: infinite, not a number, denormal.
  double any_real() { return std::bit_cast<double>(bits()); }

 private:
  std::string_view bytes_;
};

/// A number that depends on all bytes: checks that take long are made for some inputs alone, which no mutation aims at.
/// FNV-1a.
inline std::uint64_t hash_of(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : bytes) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001b3U;
  return hash;
}

}  // namespace whittle::test
