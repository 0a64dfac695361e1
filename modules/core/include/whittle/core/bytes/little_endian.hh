#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <type_traits>

// Numbers in little-endian byte order.

namespace whittle {

/// Decodes the little-endian number at `bytes`.
template <class Number>
Number load(const char* bytes, std::endian order) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), bytes, raw.size());
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<Number>(raw);
}
template <class Number>
Number load_little_endian(const char* bytes) {
  return load<Number>(bytes, std::endian::little);
}

/// Writes the bytes of a number, lowest first. \param to `sizeof value` bytes
template <class Number>
void store_little_endian(Number value, char* to) {
  static_assert(std::is_arithmetic_v<Number>);
  auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  std::memcpy(to, raw.data(), raw.size());
}
template <class Number>
void append_little_endian(std::string& bytes, Number value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(value));
  store_little_endian(value, bytes.data() + at);
}

}  // namespace whittle
