#include "whittle/core/detail/thread_pool.hh"

#include <system_error>

#include "whittle/core/detail/compiler.hh"
#include "whittle/core/detail/cores.hh"

namespace whittle {
namespace {

/// About 50 µs: longer than most pauses between jobs, short against a time slice.
constexpr int spins_before_sleep = 2000;

}  // namespace

ThreadPool::ThreadPool(unsigned threads) {
  const unsigned cores = detail::n_cores();
  const unsigned n_helpers = (threads == 0 ? cores : std::min(threads, cores)) - 1;
  helpers_.reserve(n_helpers);
  try {
    for (unsigned i = 0; i < n_helpers; ++i) helpers_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
    // Thread creation failed; continue with the threads we have.
  }
}

ThreadPool::~ThreadPool() {
  is_over_ = true;
  job_ += 2;  // wakes the helpers without a job
  wake_helpers();
  for (std::thread& helper : helpers_) helper.join();
}

void ThreadPool::run(std::size_t n_blocks, const std::function<void(std::size_t)>& work) {
  work_ = &work;
  n_blocks_ = n_blocks;
  next_block_ = 0;
  ++job_;
  wake_helpers();
  take_blocks();
  ++job_;  // helpers that wake up now are too late
  while (n_at_work_ != 0) pause_processor();
}

/// \pre `job_` has changed. Whoever has seen the old one under the lock sleeps already, and is woken.
void ThreadPool::wake_helpers() {
  if (helpers_.empty()) return;
  { const std::lock_guard lock(mutex_); }
  job_changed_.notify_all();
}

void ThreadPool::take_blocks() {
  for (std::size_t block = next_block_++; block < n_blocks_; block = next_block_++) (*work_)(block);
}

void ThreadPool::help() {
  unsigned seen = 0;
  while (!is_over_) {
    const unsigned job = job_;
    if (job == seen) {
      int n_spins = 0;
      while (job_ == seen && ++n_spins < spins_before_sleep) pause_processor();
      if (job_ == seen) {
        std::unique_lock lock(mutex_);
        job_changed_.wait(lock, [&] { return job_ != seen; });
      }
      continue;
    }
    ++n_at_work_;
    if (job % 2 == 1 && job_ == job) take_blocks();  // still the same job: the caller waits for this helper
    --n_at_work_;
    seen = job;
  }
}

}  // namespace whittle
