#include "whittle/core/detail/item_groups.hh"

#include <gmock/gmock.h>

#include <random>
#include <set>

namespace whittle::detail {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(ItemGroups, AreAscendingAndCompleteOnAnyNumberOfThreads) {
  std::mt19937 random(1);
  for (const std::size_t n_items : {0U, 1U, 1000U, 100'000U}) {
    for (const std::size_t n_groups : {1U, 7U, 300U}) {
      std::vector<std::set<std::size_t>> groups_of(n_items);
      std::vector<std::vector<Index>> expected(n_groups);
      for (Index item = 0; item < n_items; ++item) {
        for (unsigned i = random() % 4; i > 0; --i) groups_of[item].insert(random() % n_groups);
        for (const std::size_t group : groups_of[item]) expected[group].push_back(item);
      }
      for (const unsigned threads : {1U, 2U, 5U}) {
        const ItemGroups groups(n_items, n_groups, threads, [&](Index item, const auto& use) {
          for (const std::size_t group : groups_of[item]) use(group);
        });
        ASSERT_EQ(groups.size(), n_groups);
        for (std::size_t group = 0; group < n_groups; ++group) {
          const std::span<const Index> items = groups.of(group);
          EXPECT_EQ(std::vector<Index>(items.begin(), items.end()), expected[group]);
        }
      }
    }
  }
}

TEST(ItemGroups, HasNoneWithoutAsking) { EXPECT_EQ(ItemGroups().size(), 0U); }

/// Per vertex, its faces in the order in which ranges of vertices show them.
std::vector<std::vector<Index>> seen_at(const std::vector<Triangle>& faces, std::size_t n_vertices, unsigned threads) {
  std::vector<std::vector<Index>> seen(n_vertices);
  std::vector<int> n_visits(n_vertices);
  for_each_vertex_range(faces, n_vertices, threads, [&](Index begin, Index end, const auto& for_each_face) {
    for (Index v = begin; v < end; ++v) ++n_visits[v];
    for_each_face([&](Index f) {
      for (const Index v : faces[f]) {
        if (v >= begin && v < end) seen[v].push_back(f);
      }
    });
  });
  EXPECT_THAT(n_visits, testing::Each(1));
  return seen;
}

TEST(VertexRanges, ShowEachVertexItsFacesInOrder) {
  std::mt19937 random(2);
  const std::size_t n_vertices = 3 * range_length + 5;
  std::vector<Triangle> faces;
  for (std::size_t f = 0; f < 100'000; ++f) {
    const auto any = [&] { return static_cast<Index>(random() % n_vertices); };
    faces.push_back({any(), any(), any()});
  }
  std::vector<std::vector<Index>> expected(n_vertices);
  for (Index f = 0; f < faces.size(); ++f) {
    for (const Index v : faces[f]) expected[v].push_back(f);
  }
  for (const unsigned threads : {1U, 2U, 5U}) EXPECT_EQ(seen_at(faces, n_vertices, threads), expected);
}

TEST(VertexRanges, MayBeEmpty) {
  EXPECT_THAT(seen_at({}, 0, 1), IsEmpty());
  EXPECT_THAT(seen_at({}, 0, 2), IsEmpty());
  EXPECT_THAT(seen_at({}, 1, 2), ElementsAre(IsEmpty()));
}

}  // namespace
}  // namespace whittle::detail
