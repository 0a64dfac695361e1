#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace whittle::bench {

/// Measures a peer between `start()` and `stop()`. The peer calls each once, around the decimation alone. Converting
/// the arrays before and after doesn't count.
class Meter {
 public:
  enum class Memory {
    ignored,
    /// Returns freed memory to the system at the start, so that all memory used counts as new. A peer that reuses its
    /// own freed memory is faster.
    watched
  };
  explicit Meter(Memory memory = Memory::ignored) : memory_(memory) {}

  void start();
  void stop();

  double wall_ms() const { return wall_ms_; }
  /// Processor time of all threads of the process, user and system.
  double cpu_ms() const { return cpu_ms_; }
  /// Greatest resident size since the start, less that at the start. None unless watched, or if the system doesn't
  /// report it.
  std::optional<std::uint64_t> peak_bytes() const { return peak_bytes_; }

 private:
  Memory memory_;
  double wall_ms_ = 0;
  double cpu_ms_ = 0;
  std::optional<std::uint64_t> resident_at_start_;
  std::optional<std::uint64_t> peak_bytes_;
};

}  // namespace whittle::bench
