#pragma once

#include <optional>

#include "terminal/progress_bar.hh"
#include "terminal/talk.hh"
#include "whittle/engine/options.hh"

namespace whittle::app {

/// Draws a progress bar for each stage of a simplification, and ends the run if a signal is pending.
class StageBars {
 public:
  explicit StageBars(const Talk& talk) : talk_(talk) {}

  /// For `DecimateOptions::progress`. \return false to end the run
  bool update(const Progress& progress);

 private:
  const Talk& talk_;
  Stage stage_ = Stage::decimate;
  std::optional<ProgressBar> bar_;
};

}  // namespace whittle::app
