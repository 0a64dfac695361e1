#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <exception>
#include <string_view>

#include "whittle/pipeline/run.hh"

namespace whittle::python {

/// Tells Python of the progress of a call that has released the interpreter: a callable gets the stage and the fraction
/// of it, some twenty times a second. Ctrl-C, and an exception of the callable, end the call.
class Observer {
 public:
  /// \param callable or None
  explicit Observer(nanobind::object callable) : callable_(std::move(callable)) {}

  /// For calls that observe a run.
  RunObserver of_run() {
    return [this](const RunProgress& progress) { return goes_on(progress.stage, progress.fraction); };
  }
  /// For other tasks. \param stage if the task names none
  ProgressCallback of_task(std::string_view stage) {
    return [this, stage](const TaskProgress& progress) {
      return goes_on(progress.stage.empty() ? stage : progress.stage, progress.fraction);
    };
  }

  /// Calls a function without the interpreter. \throw what ended it in Python
  template <class Function>
  auto call(const Function& function) {
    try {
      const nanobind::gil_scoped_release without_interpreter;
      return function();
    } catch (const Cancelled&) {
      if (error_) std::rethrow_exception(error_);
      throw;
    }
  }

  /// \throw Cancelled if Python has ended the call
  void check() const {
    if (error_) throw Cancelled();
  }

 private:
  bool goes_on(std::string_view stage, double fraction);

  nanobind::object callable_;
  std::chrono::steady_clock::time_point last_{};
  std::exception_ptr error_;  ///< in Python, that ended the call
};

}  // namespace whittle::python
