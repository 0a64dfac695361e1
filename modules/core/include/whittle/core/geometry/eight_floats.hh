#pragma once

#include <array>
#include <cstdint>

#include "whittle/core/detail/lanes.hh"

// Eight numbers side by side: one instruction where the processor has AVX2.
namespace whittle::detail {

using Float8 = Lanes<float, 8>;
using Int8 = Lanes<std::int32_t, 8>;

/// Their storage.
using EightFloats = std::array<float, 8>;

WHITTLE_INLINE Float8 load(const EightFloats& from) { return load_lanes<Float8>(from.data()); }

}  // namespace whittle::detail
