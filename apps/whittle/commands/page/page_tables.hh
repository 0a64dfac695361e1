#pragma once

#include <string>

#include "files/report.hh"
#include "whittle/report/page.hh"

namespace whittle::app {

/// A row a value: the keys that lead to it, with spaces, and the value. Nulls are left out.
report::PageTable table_of(const std::string& title, const Json& json);

}  // namespace whittle::app
