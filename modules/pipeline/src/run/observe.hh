#pragma once

#include "whittle/core/progress.hh"
#include "whittle/pipeline/plan.hh"

namespace whittle {

/// Tells the observer of a task as a part of a stage, from one fraction of it to another.
/// \param observer must outlive the callback; may be empty
inline ProgressCallback observed(const RunObserver& observer, std::string_view stage, double from, double to) {
  if (!observer) return {};
  return [&observer, stage, from, to](const TaskProgress& progress) {
    return observer({stage, from + progress.fraction * (to - from), 0});
  };
}

}  // namespace whittle
