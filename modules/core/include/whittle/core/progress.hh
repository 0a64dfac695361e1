#pragma once

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

}  // namespace whittle
