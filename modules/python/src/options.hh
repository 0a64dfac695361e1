#pragma once

#include <nanobind/nanobind.h>

namespace whittle::python {

/// Adds `option_rows`, which tells Python all options.
void bind_options(nanobind::module_& module);

}  // namespace whittle::python
