#pragma once

#include <functional>
#include <string>

namespace whittle::bench {

/// What `work` returns, called in a process of its own that is forked for it: what it takes from the system is its own,
/// what it leaves behind goes with it, and nobody else falls with it. Memory that was freed before is given back to the
/// system first.
/// \pre the process has no other threads
/// \param limit_s seconds after which it is ended
/// \throw std::runtime_error with what `work` threw, or with how else it ended
std::string run_forked(const std::function<std::string()>& work, double limit_s);

}  // namespace whittle::bench
