#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace whittle::detail {

/// How many threads can run at once: on the cores that this process may use, and no more than its control groups
/// allow, such as a container's. At least 1. It is found out once.
unsigned n_cores();

/// \param of_processor 0 if that isn't known \param allowed by control groups \return at least 1
unsigned usable_cores(unsigned of_processor, std::optional<unsigned> allowed);

/// How many cores control groups allow, rounded up; nothing if they set no limit. Of a group and those that it is in,
/// the least counts.
/// \param groups content of /proc/self/cgroup \param root where control groups are mounted, of version 1 or 2
std::optional<unsigned> cores_allowed(std::string_view groups, const std::filesystem::path& root);

}  // namespace whittle::detail
