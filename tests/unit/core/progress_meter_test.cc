#include "whittle/core/detail/progress_meter.hh"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace whittle::test {
namespace {

using detail::ProgressMeter;
using detail::Workers;

TEST(ProgressMeter, GoesFromStageToStageAndNeverFalls) {
  std::vector<std::string> stages;
  double last = 0;
  ProgressMeter meter([&](const TaskProgress& progress) {
    EXPECT_GE(progress.fraction, last);
    EXPECT_LE(progress.fraction, 1);
    last = progress.fraction;
    stages.emplace_back(progress.stage);
    return true;
  });
  meter.start("first", 0.25);
  EXPECT_EQ(last, 0);
  meter.start("second", 1);
  EXPECT_EQ(last, 0.25);
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  meter.update(0.5);
  EXPECT_EQ(last, 0.625);
  meter.finish();
  EXPECT_EQ(last, 1);
  EXPECT_EQ(stages, (std::vector<std::string>{"first", "second", "second", "second"}));
}

TEST(ProgressMeter, IsSilentWithoutACallback) {
  ProgressMeter meter{ProgressCallback()};
  meter.start("any", 1);
  meter.update(0.5);
  meter.finish();
}

/// Only the calling thread reports; all threads stop.
TEST(ProgressMeter, CancelsWorkOnAllThreads) {
  for (const unsigned threads : {1U, 2U, 8U}) {
    SCOPED_TRACE(threads);
    const std::thread::id caller = std::this_thread::get_id();
    const auto start = std::chrono::steady_clock::now();
    ProgressMeter meter([&](const TaskProgress&) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      return std::chrono::steady_clock::now() - start < std::chrono::milliseconds(50);
    });
    meter.start("waiting", 1);
    std::atomic<std::size_t> n_blocks{0};
    const Workers workers(threads, &meter);
    EXPECT_THROW(for_each_block(std::size_t{100'000}, workers,
                                [&](std::size_t) {
                                  ++n_blocks;
                                  std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                }),
                 Cancelled);
    EXPECT_LT(n_blocks, 10'000U);
  }
}

TEST(Workers, MeetEachElementOnce) {
  for (const unsigned threads : {1U, 3U}) {
    std::vector<int> n_met(100'000);
    for_each_range(n_met.size(), Workers(threads), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++n_met[i];
    });
    EXPECT_EQ(n_met, std::vector<int>(n_met.size(), 1));
  }
}

TEST(Cancelled, IsAnExceptionThatSaysSo) {
  const auto cancel = [] { throw Cancelled(); };
  try {
    cancel();
  } catch (const std::exception& error) {
    EXPECT_STREQ(error.what(), "cancelled");
  }
}

}  // namespace
}  // namespace whittle::test
