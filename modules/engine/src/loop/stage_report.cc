#include "loop/stage_report.hh"

#include <utility>

namespace whittle {
namespace {

void add_steps(RunSteps next, RunSteps& steps) {
  for (PassEnd& end : next.pass_ends) {
    end.n_contractions += steps.contractions.size();
    steps.pass_ends.push_back(std::move(end));
  }
  if (steps.contractions.empty()) {
    steps.contractions = std::move(next.contractions);
  } else {
    steps.contractions.insert(steps.contractions.end(), next.contractions.begin(), next.contractions.end());
  }
}

}  // namespace

StageReport& StageReport::operator+=(StageReport next) {
  result.n_vertices = 0;
  result.n_faces = 0;
  result.stop = StopReason::target;  // the least
  result.refused_at_end = {};
  result += next.result;
  add_steps(std::move(next.steps), steps);
  refused_pairs = std::move(next.refused_pairs);
  progress = next.progress;
  return *this;
}

}  // namespace whittle
