#include "observer.hh"

namespace whittle::python {

bool Observer::goes_on(std::string_view stage, double fraction) {
  using namespace std::chrono_literals;
  if (error_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < 50ms) return true;
  last_ = now;
  const nanobind::gil_scoped_acquire with_interpreter;
  try {
    if (PyErr_CheckSignals() != 0) throw nanobind::python_error();
    if (!callable_.is_none()) callable_(nanobind::str(stage.data(), stage.size()), fraction);
  } catch (const nanobind::python_error&) {
    error_ = std::current_exception();
    return false;
  }
  return true;
}

}  // namespace whittle::python
