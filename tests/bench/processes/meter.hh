#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace whittle::bench {

/// Measures what a peer does between `start()` and `stop()`, which it calls once each, around the decimation alone:
/// what it does before and after, to take the arrays over and to give them back, doesn't count.
class Meter {
 public:
  enum class Memory {
    ignored,
    /// Gives freed memory back to the system at the start, so that all of what is used counts as new. A peer that
    /// meets its own freed memory is faster.
    watched
  };
  explicit Meter(Memory memory = Memory::ignored) : memory_(memory) {}

  void start();
  void stop();

  double wall_ms() const { return wall_ms_; }
  /// Of all threads of the process, user and system.
  double cpu_ms() const { return cpu_ms_; }
  /// Greatest resident size since the start, beyond the one at the start; none unless watched, or where the system
  /// doesn't tell it.
  std::optional<std::uint64_t> peak_bytes() const { return peak_bytes_; }

 private:
  Memory memory_;
  double wall_ms_ = 0;
  double cpu_ms_ = 0;
  std::optional<std::uint64_t> resident_at_start_;
  std::optional<std::uint64_t> peak_bytes_;
};

}  // namespace whittle::bench
