#pragma once

#include <nanobind/nanobind.h>

namespace whittle::python {

void bind_polish(nanobind::module_& module);

}  // namespace whittle::python
