#pragma once

#include <optional>
#include <string_view>

#include "terminal/progress_bar.hh"
#include "terminal/talk.hh"
#include "whittle/engine/options.hh"
#include "whittle/pipeline/plan.hh"

namespace whittle::app {

/// Draws a progress bar for each stage of a run, and ends the run if a signal is pending.
class StageBars {
 public:
  explicit StageBars(const Talk& talk) : talk_(talk) {}

  /// Callback for `RunObserver`. \return false to end the run
  bool update(const RunProgress& progress);
  /// Callback for `DecimateOptions::progress`.
  bool update(const Progress& progress);

 private:
  const Talk& talk_;
  std::string_view stage_;
  std::optional<ProgressBar> bar_;
};

}  // namespace whittle::app
