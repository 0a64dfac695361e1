#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <thread>
#include <utility>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/progress.hh"

namespace whittle::detail {

/// Passes the progress of a task that consists of stages on to a callback, and ends the task when this cancels it.
///
/// Only the thread that made the meter calls the callback, at most every 20 ms within a stage.
class ProgressMeter {
 public:
  explicit ProgressMeter(ProgressCallback callback) : callback_(std::move(callback)) {}

  /// Ends the current stage and begins the next.
  /// \param until fraction of the whole task at this stage's end
  /// \throw Cancelled
  void start(std::string_view stage, double until) {
    if (!callback_) return;
    stage_ = stage;
    begin_ = end_;
    end_ = until;
    report(begin_);
  }
  /// Reports completion. Can't cancel.
  void finish() {
    if (callback_) callback_({1, stage_});
  }
  /// May be called by any thread. \param share of this stage that is done, [0, 1]
  /// \throw Cancelled, by all threads once the callback has cancelled the task
  void update(double share) {
    if (!callback_) return;
    if (is_cancelled_.load(std::memory_order_relaxed)) throw Cancelled();
    if (std::this_thread::get_id() != owner_ || Clock::now() < next_) return;
    report(begin_ + share * (end_ - begin_));
  }

 private:
  using Clock = std::chrono::steady_clock;

  void report(double fraction) {
    fraction_ = std::max(fraction_, std::min(fraction, 1.0));
    if (!callback_({fraction_, stage_})) {
      is_cancelled_.store(true, std::memory_order_relaxed);
      throw Cancelled();
    }
    next_ = Clock::now() + std::chrono::milliseconds(20);
  }

  ProgressCallback callback_;
  std::thread::id owner_ = std::this_thread::get_id();
  std::atomic<bool> is_cancelled_{false};
  std::string_view stage_;
  double begin_ = 0;     ///< of the stage, as a fraction of the task
  double end_ = 0;       ///< of the stage
  double fraction_ = 0;  ///< reported last
  Clock::time_point next_{};
};

/// The threads that a function may use, and the meter to which it reports.
struct Workers {
  unsigned threads = 0;            ///< 0 = all cores
  ProgressMeter* meter = nullptr;  ///< none: no progress, no cancelling

  Workers(unsigned n_threads, ProgressMeter* the_meter = nullptr) : threads(n_threads), meter(the_meter) {}

  /// \throw Cancelled
  void update(double share) const {
    if (meter != nullptr) meter->update(share);
  }
};

/// The functions of parallel.hh, with an update before each block.
template <class Work>
void for_each_block(std::size_t n_blocks, const Workers& workers, const Work& work) {
  whittle::for_each_block(n_blocks, workers.threads, [&](std::size_t block) {
    workers.update(static_cast<double>(block) / static_cast<double>(n_blocks));
    work(block);
  });
}
template <class Work>
void for_each_range(std::size_t n, const Workers& workers, const Work& work) {
  whittle::for_each_range(n, workers.threads, [&](std::size_t begin, std::size_t end) {
    workers.update(static_cast<double>(begin) / static_cast<double>(n));
    work(begin, end);
  });
}

}  // namespace whittle::detail
