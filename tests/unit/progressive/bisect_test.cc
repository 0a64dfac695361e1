#include "whittle/engine/detail/bisect.hh"

#include <gtest/gtest.h>

namespace whittle::detail {
namespace {

/// What the search asks of numbers that hold up to `last`, and how often.
struct Asked {
  std::size_t last;
  std::size_t n_holding = 0;
  std::size_t n_others = 0;

  bool ask(std::size_t number) {
    const bool holds = number <= last;
    ++(holds ? n_holding : n_others);
    return holds;
  }
};

Asked from_end_of_thousand(std::size_t last) {
  Asked asked{last};
  bisect_from_end(
      1000, [] { return std::size_t{1}; }, [&asked](std::size_t number) { return asked.ask(number); });
  return asked;
}

TEST(Bisect, FindsTheLastToTheGap) {
  for (const std::size_t n : {1U, 2U, 3U, 50U, 1000U}) {
    for (std::size_t last = 0; last < n; ++last) {
      for (const std::size_t gap : {1U, 7U}) {
        const auto is_allowed = [gap] { return gap; };
        const auto holds = [last](std::size_t number) { return number <= last; };
        for (const std::size_t found : {bisect(0, n, is_allowed, holds), bisect_from_end(n, is_allowed, holds)}) {
          EXPECT_LE(found, last);
          EXPECT_LT(last, found + gap);
        }
      }
    }
  }
}

TEST(Bisect, FromTheEndAsksOnceWhereTheLastNumberHolds) {
  const Asked asked = from_end_of_thousand(999);
  EXPECT_EQ(asked.n_holding, 1U);
  EXPECT_EQ(asked.n_others, 0U);
}

/// Numbers near the end are found with few that hold: those may take long.
TEST(Bisect, FromTheEndAsksForFewThatHold) {
  for (const std::size_t last : {998U, 990U, 900U}) {
    const Asked asked = from_end_of_thousand(last);
    EXPECT_LE(asked.n_holding + asked.n_others, 14U) << last;
  }
}

}  // namespace
}  // namespace whittle::detail
