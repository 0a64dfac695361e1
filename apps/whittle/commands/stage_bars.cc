#include "commands/stage_bars.hh"

#include <string>

#include "terminal/interruption.hh"
#include "whittle/core/text/text.hh"

namespace whittle::app {

bool StageBars::update(const RunProgress& progress) {
  if (!bar_ || progress.stage != stage_) {
    stage_ = progress.stage;
    bar_.reset();
    bar_.emplace(talk_, std::string(stage_));
  }
  bar_->update(progress.fraction, progress.n_faces > 0 ? faces_text(progress.n_faces) : std::string());
  return !SignalsWait::pending();
}

bool StageBars::update(const Progress& progress) { return update(run_progress(progress)); }

}  // namespace whittle::app
