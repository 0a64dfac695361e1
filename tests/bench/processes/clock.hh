#pragma once

namespace whittle::bench {

enum class Clock {
  wall,
  cpu  ///< of all threads together, user and system
};

/// The name that the rows give it.
constexpr const char* to_string(Clock clock) { return clock == Clock::wall ? "wall" : "cpu"; }

}  // namespace whittle::bench
