#pragma once

#include <atomic>
#include <cstddef>

namespace whittle::test {

/// Bytes of the largest single allocation by `new` since this was last set to 0.
extern std::atomic<std::size_t> largest_allocation;

}  // namespace whittle::test
