#include "whittle/core/detail/section_trace.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <thread>

#include "whittle/core/detail/parallel.hh"

namespace whittle::detail {
namespace {

void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

TEST(SectionTrace, TimesEachBlockOfEachSection) {
  for (const unsigned threads : {1U, 3U}) {
    SCOPED_TRACE(threads);
    const SectionTrace trace;
    for_each_block(5, threads, [](std::size_t) { wait(); });
    for_each_block(2, threads, [](std::size_t) { wait(); });
    ASSERT_EQ(trace.sections().size(), 2U);
    EXPECT_EQ(trace.sections()[0].blocks.size(), 5U);
    EXPECT_EQ(trace.sections()[1].blocks.size(), 2U);
    for (const SectionTrace::Section& section : trace.sections()) {
      for (const double seconds : section.blocks) EXPECT_GE(seconds, 0.002);
      const double all = std::accumulate(section.blocks.begin(), section.blocks.end(), 0.0);
      EXPECT_GE(section.seconds, *std::max_element(section.blocks.begin(), section.blocks.end()));
      if (threads == 1) {
        EXPECT_GE(section.seconds, all);
      }
    }
  }
}

TEST(SectionTrace, TakesSectionsWithinBlocksForPartsOfThem) {
  for (const unsigned threads : {1U, 3U}) {
    const SectionTrace trace;
    for_each_block(3, threads, [&](std::size_t) { for_each_block(4, 1, [](std::size_t) { wait(); }); });
    ASSERT_EQ(trace.sections().size(), 1U);
    for (const double seconds : trace.sections()[0].blocks) EXPECT_GE(seconds, 0.008);
  }
}

TEST(SectionTrace, EndsWithItsLife) {
  const SectionTrace outer;
  {
    const SectionTrace inner;
    for_each_block(2, 1, [](std::size_t) {});
    EXPECT_EQ(inner.sections().size(), 1U);
  }
  EXPECT_TRUE(outer.sections().empty());
  for_each_block(2, 1, [](std::size_t) {});
  EXPECT_EQ(outer.sections().size(), 1U);
  EXPECT_THROW(for_each_block(2, 2, [](std::size_t) { throw 1; }), int);
  EXPECT_EQ(outer.sections().size(), 2U);
}

}  // namespace
}  // namespace whittle::detail
