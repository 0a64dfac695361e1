#pragma once

#include <algorithm>
#include <cstddef>

#include "whittle/core/detail/parallel.hh"

namespace whittle {

/// Vertices that a thread takes at a time in a round.
inline constexpr std::size_t chunk_length = 2048;

inline std::size_t n_chunks_of(std::size_t n) { return (n + chunk_length - 1) / chunk_length; }

/// Calls `work(chunk, begin, end)` for parts that together make up 0 … n, in any order.
template <class Work>
void for_each_chunk(std::size_t n, unsigned threads, const Work& work) {
  for_each_block(n_chunks_of(n), threads, [&](std::size_t chunk) {
    work(chunk, chunk * chunk_length, std::min(n, (chunk + 1) * chunk_length));
  });
}

}  // namespace whittle
