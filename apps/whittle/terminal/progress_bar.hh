#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "terminal/talk.hh"
#include "whittle/core/progress.hh"

namespace whittle::app {

/// A line on a terminal that is redrawn in place, and erased by the destructor. It is green if `Talk::is_colored`.
/// Nothing is drawn if `Talk::shows_progress` is false.
class ProgressBar {
 public:
  /// \param what a few words for the work
  ProgressBar(const Talk& talk, std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Redraws, at most ten times a second. \param fraction done, [0, 1] \param note a few words after the percentage
  void update(double fraction, const std::string& note);

 private:
  void clear();

  std::string what_;
  bool shown_;
  bool colored_;
  std::size_t drawn_width_ = 0;
  std::chrono::steady_clock::time_point next_;
};

/// Shows a task of the library as a part of the bar, from one fraction of it to another. Cancels the task if a signal
/// is pending. \param bar must outlive the callback
ProgressCallback part_of(ProgressBar& bar, double from, double to);

}  // namespace whittle::app
