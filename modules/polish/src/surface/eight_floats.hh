#pragma once

#include <array>
#include <cstdint>
#include <cstring>

// Eight numbers side by side: one instruction where the processor has AVX2.
namespace whittle::polishing {

using Float8 = float __attribute__((vector_size(32)));
using Int8 = std::int32_t __attribute__((vector_size(32)));

/// How they are stored.
using EightFloats = std::array<float, 8>;

[[gnu::always_inline]] inline Float8 load(const EightFloats& from) {
  Float8 lanes;
  std::memcpy(&lanes, from.data(), sizeof(lanes));
  return lanes;
}

}  // namespace whittle::polishing
