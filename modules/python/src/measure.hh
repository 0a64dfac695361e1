#pragma once

#include <nanobind/nanobind.h>

namespace whittle::python {

/// Adds what is measured and proven of meshes.
void bind_measure(nanobind::module_& module);

}  // namespace whittle::python
