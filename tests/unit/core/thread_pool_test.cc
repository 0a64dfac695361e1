#include "whittle/core/detail/thread_pool.hh"

#include <gtest/gtest.h>

#include <numeric>

namespace whittle::test {
namespace {

class ThreadPoolOf : public testing::TestWithParam<unsigned> {};

/// Thousands of short jobs in succession. Each element is visited once, and all of them before the call returns.
TEST_P(ThreadPoolOf, MeetsEachElementOnce) {
  ThreadPool pool(GetParam());
  std::vector<int> n_met(1000);
  for (std::size_t job = 0; job < 5000; ++job) {
    const std::size_t n = job % n_met.size();
    pool.for_each_range(n, 1 + job % 70, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++n_met[i];
    });
    ASSERT_EQ(std::accumulate(n_met.begin(), n_met.end(), 0), static_cast<int>(n)) << "job " << job;
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(n_met[i], 1) << "job " << job << ", element " << i;
    std::fill(n_met.begin(), n_met.end(), 0);
  }
}

TEST_P(ThreadPoolOf, EndsWithoutAJob) { const ThreadPool pool(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Threads, ThreadPoolOf, testing::Values(0, 1, 2, 8), testing::PrintToStringParamName());

}  // namespace
}  // namespace whittle::test
