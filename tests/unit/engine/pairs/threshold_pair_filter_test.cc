#include "pairs/threshold_pair_filter.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace whittle::test {
namespace {

/// Two triangles apart, with these threshold pairs between them.
TriangleComplex triangles_with(const std::vector<VertexPair>& threshold_pairs) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  const std::vector<Triangle> faces = {{0, 1, 2}, {3, 4, 5}};
  TriangleComplex complex(points, faces, Frame{}, 1);
  complex.connect(threshold_pairs, 1);
  return complex;
}

TEST(ThresholdPairFilter, PutsEdgesBeforePairs) {
  TriangleComplex complex = triangles_with({{0, 3}, {1, 4}});
  std::vector<Index> pairs = {7, 2, 6, 5};
  ThresholdPairFilter(complex).apply(pairs);
  EXPECT_THAT(std::vector<Index>(pairs.begin(), pairs.begin() + 2), testing::UnorderedElementsAre(2, 5));
  EXPECT_THAT(std::vector<Index>(pairs.begin() + 2, pairs.end()), testing::UnorderedElementsAre(6, 7));
}

TEST(ThresholdPairFilter, DropsPairsThatAreEqualToOthers) {
  TriangleComplex complex = triangles_with({{0, 3}, {0, 3}});
  std::vector<Index> pairs = {6, 7};
  ThresholdPairFilter(complex).apply(pairs);
  EXPECT_THAT(pairs, testing::ElementsAre(6));
  EXPECT_FALSE(complex.is_pair_alive(7));
}

TEST(ThresholdPairFilter, DropsPairsThatHaveBecomeOneVertex) {
  TriangleComplex complex = triangles_with({{1, 1}});
  std::vector<Index> pairs = {6};
  ThresholdPairFilter(complex).apply(pairs);
  EXPECT_THAT(pairs, testing::IsEmpty());
  EXPECT_FALSE(complex.is_pair_alive(6));
}

}  // namespace
}  // namespace whittle::test
