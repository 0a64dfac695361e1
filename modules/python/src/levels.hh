#pragma once

#include <nanobind/nanobind.h>

namespace whittle::python {

/// Adds levels of detail, and recordings of runs.
void bind_levels(nanobind::module_& module);

}  // namespace whittle::python
