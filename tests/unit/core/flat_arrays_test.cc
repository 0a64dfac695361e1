#include "whittle/core/flat_arrays.hh"

#include <gtest/gtest.h>

#include <vector>

namespace whittle {
namespace {

TEST(FlatArrays, HaveTheNumbersOfTheMeshInTheirOrder) {
  IndexedMesh mesh;
  mesh.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  mesh.faces = {{0, 1, 2}, {2, 1, 3}};
  const auto positions = flat_positions(mesh);
  EXPECT_EQ(std::vector<double>(positions.begin(), positions.end()),
            (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
  const auto faces = flat_faces(mesh);
  EXPECT_EQ(std::vector<Index>(faces.begin(), faces.end()), (std::vector<Index>{0, 1, 2, 2, 1, 3}));
}

TEST(FlatArrays, OfAnEmptyMeshAreEmpty) {
  EXPECT_TRUE(flat_positions({}).empty());
  EXPECT_TRUE(flat_faces({}).empty());
}

}  // namespace
}  // namespace whittle
