#pragma once

#include <concepts>

namespace whittle {

/// `condition ? yes : no` without a branch, for unpredictable conditions.
template <std::unsigned_integral T>
T select_branch_free(bool condition, T yes, T no) {
  return no ^ ((no ^ yes) & (T{0} - T{condition}));
}

}  // namespace whittle
