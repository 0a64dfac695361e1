#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace whittle::detail {

/// How many threads can run at once: on the cores that this process may use, and no more than its control groups
/// allow, such as a container's. At least 1. It is found out once.
unsigned n_cores();

/// How many cores control groups allow, rounded up; nothing if they set no limit. Of a group and those that it is in,
/// the least counts.
/// \param groups content of /proc/self/cgroup \param root where control groups are mounted, of version 1 or 2
std::optional<unsigned> cores_allowed(std::string_view groups, const std::filesystem::path& root);

}  // namespace whittle::detail
