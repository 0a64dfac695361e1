#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hh"
#include "whittle/pipeline/request.hh"

namespace whittle::python {

/// What Python asks of a run.
struct Wishes {
  std::vector<std::pair<std::string, std::string>> options;  ///< "--max-error" and its value, empty for a flag
  std::optional<Array> locked;                               ///< per point that was given
  bool certificate = false;
  bool recording = false;
  unsigned threads = 0;
};

/// All of them but the options.
Request request_of(const Wishes& wishes);

/// Sets the options of a request. \return a warning for each that does nothing
/// \throw std::invalid_argument for an unknown option, a value out of range, options that don't go together, or if
///        there is no target
std::vector<std::string> set_options(const Wishes& wishes, Request& request);

void bind_wishes(nb::module_& module);

}  // namespace whittle::python
