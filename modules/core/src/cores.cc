#include "whittle/core/detail/cores.hh"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace whittle::detail {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::optional<double> number_in(const fs::path& file) {
  std::ifstream stream(file);
  double number = 0;
  if (stream >> number) return number;
  return std::nullopt;
}

/// Processor time a period, over the period. Version 2 has both in one file, "max 100000" where there is no limit;
/// version 1 has two files, and −1 for no limit.
std::optional<double> limit_of(const fs::path& group) {
  std::ifstream both(group / "cpu.max");
  double quota = 0;
  double period = 0;
  if (!(both >> quota >> period)) {
    quota = number_in(group / "cpu.cfs_quota_us").value_or(-1);
    period = number_in(group / "cpu.cfs_period_us").value_or(0);
  }
  if (!(quota > 0 && period > 0)) return std::nullopt;
  return quota / period;
}

/// Whether a list such as "cpu,cpuacct" has the controller of processor time. Version 2 has no names.
bool has_cpu(std::string_view controllers) {
  std::string list(1, ',');
  list.append(controllers).push_back(',');
  return controllers.empty() || list.find(",cpu,") != std::string::npos;
}

}  // namespace

std::optional<unsigned> cores_allowed(std::string_view groups, const fs::path& root) {
  std::optional<double> least;
  // Lines such as "0::/user.slice" and "4:cpu,cpuacct:/docker/7f3a".
  for (std::size_t begin = 0; begin < groups.size();) {
    const std::size_t end = std::min(groups.find('\n', begin), groups.size());
    const std::string_view line = groups.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t first = line.find(':');
    const std::size_t second = first == line.npos ? line.npos : line.find(':', first + 1);
    if (second == line.npos) continue;
    const std::string_view controllers = line.substr(first + 1, second - first - 1);
    if (!has_cpu(controllers)) continue;
    const fs::path mounted = controllers.empty() ? root : root / controllers;
    // In a container the group's own folder may be the root.
    for (fs::path group = fs::path(line.substr(second + 1)).relative_path();; group = group.parent_path()) {
      if (const std::optional<double> limit = limit_of(mounted / group))
        least = std::min(least.value_or(*limit), *limit);
      if (group.empty()) break;
    }
  }
  if (!least) return std::nullopt;
  return static_cast<unsigned>(std::ceil(std::min(*least, 1e6)));
}

unsigned usable_cores(unsigned of_processor, std::optional<unsigned> allowed) {
  const unsigned cores = std::max(1U, of_processor);
  return std::min(cores, allowed.value_or(cores));
}

unsigned n_cores() {
  static const unsigned n = usable_cores(std::thread::hardware_concurrency(),
                                         cores_allowed(content_of("/proc/self/cgroup"), "/sys/fs/cgroup"));
  return n;
}

}  // namespace whittle::detail
