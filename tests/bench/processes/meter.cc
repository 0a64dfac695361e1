#include "bench/processes/meter.hh"

#include <malloc.h>

#include <ctime>
#include <fstream>
#include <string>

namespace whittle::bench {
namespace {

double now_ms(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// The value of a line of /proc/self/status in kB: "VmRSS:", "VmHWM:".
std::optional<std::uint64_t> status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    std::uint64_t kilobytes = 0;
    if (word == key && status >> kilobytes) return 1024 * kilobytes;
  }
  return std::nullopt;
}

/// Resets "VmHWM:": it becomes the greatest resident size from now on.
bool reset_peak() {
  std::ofstream clear_refs("/proc/self/clear_refs");
  clear_refs << '5' << std::flush;
  return clear_refs.good();
}

}  // namespace

void Meter::start() {
  if (memory_ == Memory::watched) {
    malloc_trim(0);
    if (reset_peak()) resident_at_start_ = status_bytes("VmRSS:");
  }
  cpu_ms_ = now_ms(CLOCK_PROCESS_CPUTIME_ID);
  wall_ms_ = now_ms(CLOCK_MONOTONIC);
}

void Meter::stop() {
  wall_ms_ = now_ms(CLOCK_MONOTONIC) - wall_ms_;
  cpu_ms_ = now_ms(CLOCK_PROCESS_CPUTIME_ID) - cpu_ms_;
  if (!resident_at_start_) return;
  if (const auto peak = status_bytes("VmHWM:")) peak_bytes_ = *peak - *resident_at_start_;
}

}  // namespace whittle::bench
