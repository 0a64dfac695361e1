#include "commands/stage_bars.hh"

#include <string>

#include "terminal/interruption.hh"
#include "terminal/table.hh"

namespace whittle::app {

bool StageBars::update(const Progress& progress) {
  if (!bar_ || progress.stage != stage_) {
    stage_ = progress.stage;
    bar_.reset();
    bar_.emplace(talk_, stage_ == Stage::polish ? "polishing" : "decimating");
  }
  bar_->update(progress.fraction, faces_text(progress.n_faces));
  return !SignalsWait::pending();
}

}  // namespace whittle::app
