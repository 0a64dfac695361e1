#include "whittle/engine/corner_lists.hh"

#include <gtest/gtest.h>

#include <map>

#include "support/random.hh"

namespace whittle::test {
namespace {

/// Lists come and go; each keeps what was written to it, whatever happens to the others.
TEST(CornerLists, KeepListsApart) {
  Random random(1);
  CornerLists lists(std::vector<Index>(100, 6));
  std::map<Index, CornerLists::List> taken;  // by the number written to all their corners
  for (Index number = 0; number < 5000; ++number) {
    const auto size = static_cast<Index>(random.below(number % 50 == 0 ? 1000 : 20));
    CornerLists::List list = lists.allocate(size);
    EXPECT_GE(list.capacity, size);
    list.size = list.capacity;  // all the room is its own
    for (Corner& corner : lists.of(list)) corner = {number, number, number};
    taken[number] = list;
    if (taken.size() < 60) continue;
    const auto gone = std::next(taken.begin(), static_cast<std::ptrdiff_t>(random.below(59)));
    for (const Corner& corner : lists.of(gone->second)) {
      ASSERT_EQ(corner.next, gone->first);
      ASSERT_EQ(corner.previous, gone->first);
      ASSERT_EQ(corner.edge, gone->first);
    }
    lists.release(gone->second);
    taken.erase(gone);
  }
}

TEST(CornerLists, TakeRoomGivenBack) {
  CornerLists lists;
  const CornerLists::List first = lists.allocate(7);
  const CornerLists::List other = lists.allocate(7);
  lists.release(first);
  EXPECT_EQ(lists.allocate(8).begin, first.begin);  // rounded up to even sizes
  EXPECT_NE(lists.allocate(8).begin, other.begin);
}

}  // namespace
}  // namespace whittle::test
