#include "complex/neighbour_lists.hh"

#include <gtest/gtest.h>

#include <map>

#include "support/random.hh"

namespace whittle::test {
namespace {

/// Lists are allocated and freed. Each keeps its contents, whatever happens to the others.
TEST(NeighbourLists, KeepListsApart) {
  Random random(1);
  NeighbourLists lists(600, 100);
  std::map<Index, NeighbourLists::List> taken;  // by the number written to all neighbours of the list
  for (Index number = 0; number < 5000; ++number) {
    const auto size = static_cast<Index>(random.below(number % 50 == 0 ? 1000 : 20));
    NeighbourLists::List list = lists.allocate(size);
    EXPECT_GE(list.capacity, size);
    list.size = list.capacity;  // uses the full capacity
    for (Neighbour& neighbour : lists.of(list)) neighbour = {number, number};
    taken[number] = list;
    if (taken.size() < 60) continue;
    const auto gone = std::next(taken.begin(), static_cast<std::ptrdiff_t>(random.below(59)));
    for (const Neighbour& neighbour : lists.of(gone->second)) {
      ASSERT_EQ(neighbour.vertex, gone->first);
      ASSERT_EQ(neighbour.edge, gone->first);
    }
    lists.release(gone->second);
    taken.erase(gone);
  }
}

TEST(NeighbourLists, TakeRoomGivenBack) {
  NeighbourLists lists;
  const NeighbourLists::List first = lists.allocate(7);
  const NeighbourLists::List other = lists.allocate(7);
  lists.release(first);
  EXPECT_EQ(lists.allocate(8).begin, first.begin);  // sizes are rounded up to even
  EXPECT_NE(lists.allocate(8).begin, other.begin);
}

}  // namespace
}  // namespace whittle::test
