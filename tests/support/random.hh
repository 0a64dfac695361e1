#pragma once

#include <cstdint>
#include <random>
#include <whittle/core/indexed_mesh.hh>

namespace whittle::test {

/// Random numbers from a seed, the same on every platform (the distributions of the standard library are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [low, high).
  double uniform(double low = 0.0, double high = 1.0) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

  /// Uniform in [low, high)³. x is drawn first: compilers evaluate the arguments of a call in different orders.
  Vec3 uniform_vector(double low, double high) {
    Vec3 v;
    for (double& x : v) x = uniform(low, high);
    return v;
  }

  /// Uniform in [0, count); count at least 1. The bias of the remainder is below count / 2^64.
  std::uint64_t below(std::uint64_t count) { return engine_() % count; }

  std::uint64_t bits() { return engine_(); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace whittle::test
