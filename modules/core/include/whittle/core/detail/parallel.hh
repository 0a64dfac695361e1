#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "whittle/core/detail/cores.hh"
#include "whittle/core/detail/section_trace.hh"

namespace whittle {

/// \param threads 0 = all cores
inline std::size_t n_threads(unsigned threads) { return threads > 0 ? threads : detail::n_cores(); }

/// Calls `work(block)` once for each block below `n_blocks`, on up to `threads` threads (0 = all cores), in any order.
/// If each block has its own results, these are the same for any number of threads. After an exception no more blocks
/// are begun; the first exception is thrown again when all threads have ended.
template <class Work>
void for_each_block(std::size_t n_blocks, unsigned threads, const Work& work) {
  const std::size_t n_workers = std::min(n_threads(threads), n_blocks);
  detail::TracedSection section(n_blocks);
  if (n_workers <= 1) {
    for (std::size_t block = 0; block < n_blocks; ++block) section.run(block, work);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto run = [&] {
    try {
      for (std::size_t block = next++; block < n_blocks; block = next++) section.run(block, work);
    } catch (...) {
      next = n_blocks;
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> pool;
    pool.reserve(n_workers - 1);
    try {
      for (std::size_t i = 1; i < n_workers; ++i) pool.emplace_back(run);
    } catch (const std::system_error&) {
      // Thread creation failed; continue with the threads we have.
    }
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

/// Elements that a thread takes at a time: some hundred microseconds of work. Long against taking it, short against a
/// whole array.
inline constexpr std::size_t range_length = 16384;

/// Calls `work(begin, end)` for ranges that together make up 0 … n, in any order; begins are multiples of
/// `range_length`. If each element has its own results, these are the same for any number of threads.
template <class Work>
void for_each_range(std::size_t n, unsigned threads, const Work& work) {
  for_each_block((n + range_length - 1) / range_length, threads,
                 [&](std::size_t block) { work(block * range_length, std::min(n, (block + 1) * range_length)); });
}

}  // namespace whittle
