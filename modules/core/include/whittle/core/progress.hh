#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <string_view>

namespace whittle {

/// How far a function that takes long has come.
struct TaskProgress {
  double fraction = 0;          ///< [0, 1]; never falls
  std::string_view stage = {};  ///< what is being done now, a few words; may be empty
};

/// Is called from time to time, always by the thread that called the function. Returns false to cancel the function.
/// An empty one is never called. What a cancelled function leaves behind is part of its description.
using ProgressCallback = std::function<bool(const TaskProgress&)>;

/// Thrown by a function that was cancelled and has no result to return.
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
