#pragma once

#include <cstdint>
#include <cstring>

/// FNV-1a over the bits of its arguments: equal results have equal digests.
class Digest {
 public:
  void add(double x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    add(bits);
  }
  void add(std::uint64_t x) { value_ = (value_ ^ x) * 1099511628211U; }

  unsigned long long value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037U;
};
