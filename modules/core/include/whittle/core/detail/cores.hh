#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace whittle::detail {

/// Number of threads that can run at once: the cores that this process may use, limited by its control groups, such as
/// a container's. At least 1. Found out once.
unsigned n_cores();

/// \param of_processor 0 if that isn't known \param allowed by control groups \return at least 1
unsigned usable_cores(unsigned of_processor, std::optional<unsigned> allowed);

/// Number of cores that control groups allow, rounded up; empty without a limit. The least of a group and its parents
/// counts.
/// \param groups content of /proc/self/cgroup \param root mount point of control groups, version 1 or 2
std::optional<unsigned> cores_allowed(std::string_view groups, const std::filesystem::path& root);

}  // namespace whittle::detail
