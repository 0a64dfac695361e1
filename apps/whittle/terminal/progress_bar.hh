#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "terminal/talk.hh"

namespace whittle::app {

/// One line on a terminal that is redrawn in place and gone in the end. Plain where NO_COLOR is set; nothing at all
/// where `Talk::shows_progress` says no.
class ProgressBar {
 public:
  /// \param what the work, a few words.
  ProgressBar(const Talk& talk, std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Redraws, at most ten times a second. \param fraction done, [0, 1]. \param note what is left, a few words.
  void update(double fraction, const std::string& note);

 private:
  void clear();

  std::string what_;
  bool shown_;
  bool colored_;
  std::size_t drawn_width_ = 0;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace whittle::app
