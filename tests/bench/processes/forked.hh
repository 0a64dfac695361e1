#pragma once

#include <functional>
#include <string>

namespace whittle::bench {

/// Calls `work` in a forked process of its own, and returns its result. So its memory use is its own, it leaves nothing
/// behind, and a crash ends that process only. Memory that was freed before is returned to the system first.
/// \pre the process has no other threads
/// \param limit_s seconds after which the process is ended
/// \throw std::runtime_error with the message that `work` threw, or with how the process ended
std::string run_forked(const std::function<std::string()>& work, double limit_s);

}  // namespace whittle::bench
