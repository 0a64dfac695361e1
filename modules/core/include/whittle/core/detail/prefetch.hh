#pragma once

namespace whittle {

/// Asks for the cache line at `address`, which need not be valid.
inline void prefetch_line(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");  // without it GCC drops calls of this function, as without effect
}

}  // namespace whittle
