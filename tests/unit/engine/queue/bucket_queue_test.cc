#include "queue/bucket_queue.hh"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace whittle {
namespace {

/// From far below the first bucket to far above the last one.
std::vector<double> costs() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-260, 80);
  std::vector<double> costs{0, 1, std::exp2(-200), std::exp2(56), 1e300};
  for (int i = 0; i < 1000; ++i) costs.push_back(std::exp2(exponent(random)));
  return costs;
}

TEST(BucketQueue, SaysFromWhichCostOnNoBucketIsPast) {
  const std::vector<double> all = costs();
  for (const double opened : all) {
    BucketQueue queue;
    queue.fill(std::array{BucketQueue::bucket_of(opened)});
    std::vector<Index> members;
    ASSERT_TRUE(queue.open_next(members));
    EXPECT_EQ(members, std::vector<Index>{0});
    const double end = queue.end_of_past();
    EXPECT_GT(end, 0);
    EXPECT_TRUE(queue.is_past(BucketQueue::bucket_of(std::nextafter(end, 0.0))));
    const bool is_last = BucketQueue::bucket_of(opened) == BucketQueue::bucket_of(1e300);
    EXPECT_EQ(queue.is_past(BucketQueue::bucket_of(end)), is_last);
    for (std::size_t i = 0; i < all.size(); i += 97) {
      if (!is_last) {
        EXPECT_EQ(queue.is_past(BucketQueue::bucket_of(all[i])), all[i] < end) << all[i] << " " << end;
      }
    }
  }
}

TEST(BucketQueue, OpensBucketsInTheOrderOfCosts) {
  const std::vector<double> all = costs();
  BucketQueue queue;
  std::vector<BucketQueue::Bucket> buckets;
  for (const double cost : all) buckets.push_back(BucketQueue::bucket_of(cost));
  queue.fill(buckets);
  double last = 0;
  std::size_t n = 0;
  for (std::vector<Index> members; queue.open_next(members);) {
    for (const Index member : members) {
      EXPECT_GE(all[member], last);
      ++n;
    }
    if (queue.end_of_past() <= std::exp2(56)) last = std::nextafter(queue.end_of_past(), 0.0);
  }
  EXPECT_EQ(n, all.size());
}

}  // namespace
}  // namespace whittle
