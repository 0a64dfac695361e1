#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <string_view>
#include <utility>

namespace whittle {

/// Progress of a long function.
struct TaskProgress {
  double fraction = 0;          ///< [0, 1]; never falls
  std::string_view stage = {};  ///< current work, a few words; may be empty
};

/// Called from time to time, always by the thread that called the function; never if empty. Returns false to cancel the
/// function. Each function documents its state after it was cancelled.
using ProgressCallback = std::function<bool(const TaskProgress&)>;

/// Tells a task's progress as that of a part of a longer one, from one fraction to another. Empty if `progress` is.
inline ProgressCallback part_of(ProgressCallback progress, double from, double to) {
  if (!progress) return {};
  return [progress = std::move(progress), from, to](const TaskProgress& part) {
    return progress({from + part.fraction * (to - from), part.stage});
  };
}

/// Thrown by a cancelled function that has no result to return.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Wall-clock seconds since its construction.
class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace whittle
