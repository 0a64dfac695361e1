#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace whittle {

/// Threads that wait for work. For many short jobs of some ten microseconds, too short for starting threads.
///
/// A helper takes part in a job if it wakes up in time. The caller waits only for helpers that have begun. There are no
/// more threads than cores.
class ThreadPool {
 public:
  /// \param threads largest number of threads, including the caller's; 0 = all cores
  explicit ThreadPool(unsigned threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  std::size_t n_helpers() const { return helpers_.size(); }

  /// Calls `work(begin, end)` for ranges that together make up 0 … n, each at most `length` long, in any order and on
  /// any thread; returns when all is done. `work` must not throw.
  template <class Work>
  void for_each_range(std::size_t n, std::size_t length, const Work& work) {
    run((n + length - 1) / length, [&](std::size_t block) { work(block * length, std::min(n, (block + 1) * length)); });
  }

 private:
  void run(std::size_t n_blocks, const std::function<void(std::size_t)>& work);
  void wake_helpers();
  void take_blocks();
  void help();

  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t n_blocks_ = 0;
  std::atomic<std::size_t> next_block_{0};
  std::atomic<unsigned> n_at_work_{0};  ///< helpers that check for a job or work on one
  std::atomic<unsigned> job_{0};        ///< counts up; odd while there is a job
  std::atomic<bool> is_over_{false};
  // Helpers sleep on these. `std::atomic::wait` loses calls of `notify_all` in the library of GCC 12 on Windows.
  std::mutex mutex_;
  std::condition_variable job_changed_;
  std::vector<std::thread> helpers_;
};

}  // namespace whittle
