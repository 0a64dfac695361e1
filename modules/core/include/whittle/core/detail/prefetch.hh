#pragma once

namespace whittle {

/// Asks for the cache line at `address`, which need not be valid.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");  // GCC drops calls of functions that do nothing but prefetch, as having no effect
}

}  // namespace whittle
