#include "sampling/tree_pair.hh"

#include <chrono>
#include <future>
#include <system_error>

namespace whittle::metrics {

namespace {

/// Runs two tasks at the same time if there are threads. The calling thread reports until both are done.
template <class First, class Second>
void build_side_by_side(const detail::Workers& workers, const First& first, const Second& second) {
  std::future<void> other;
  if (workers.threads != 1) {
    try {
      other = std::async(std::launch::async, second);
    } catch (const std::system_error&) {
      // The system has no more threads.
    }
  }
  first();
  if (!other.valid()) return second();
  while (other.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) workers.update(1);
  other.get();
}

}  // namespace

TreePair::TreePair(const IndexedMesh& reference, const IndexedMesh& test, const Vec3& origin,
                   const detail::Workers& workers, detail::ProgressMeter& meter,
                   std::optional<TriangleTree>& of_reference)
    : reference_(of_reference) {
  const auto build_test = [&] { test_.emplace(test, origin, &meter); };
  const auto build_reference = [&] { of_reference.emplace(reference, origin, &meter); };
  if (of_reference) {
    build_test();
  } else {
    build_side_by_side(workers, build_reference, build_test);
  }
}

}  // namespace whittle::metrics
