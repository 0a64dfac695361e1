// How a mesh is cut into blocks, and how costs for them are tried.
#include "blocks/partition.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "blocks/ladder.hh"
#include "unit/engine/blocks/larger_meshes.hh"

namespace whittle::test {
namespace {

WorkingSurface surface_of(const IndexedMesh& mesh) {
  return {.positions = mesh.positions, .frame = Frame::of_points(mesh.positions), .faces = mesh.faces};
}

TEST(Partition, GivesEachFaceToOneBlockAndEachInnerVertexAllItsFaces) {
  for (const auto& [name, mesh] : larger_meshes()) {
    SCOPED_TRACE(name);
    const WorkingSurface surface = surface_of(mesh);
    for (const std::size_t size : {std::size_t{10}, std::size_t{100}, std::size_t{1000}}) {
      const Partition partition = make_partition(surface, size, 0.5, 1);
      std::vector<std::size_t> block_of_face(mesh.faces.size(), partition.n_blocks());
      std::size_t n_vertices = 0;
      for (std::size_t block = 0; block < partition.n_blocks(); ++block) {
        const auto faces = partition.faces.of(block);
        EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
        for (const Index f : faces) {
          EXPECT_EQ(block_of_face[f], partition.n_blocks()) << "face " << f << " is in two blocks";
          block_of_face[f] = block;
        }
        const auto vertices = partition.vertices.of(block);
        EXPECT_TRUE(std::is_sorted(vertices.begin(), vertices.end()));
        for (Index rank = 0; rank < vertices.size(); ++rank) {
          EXPECT_EQ(partition.block_of[vertices[rank]], block);
          EXPECT_EQ(partition.ranks[vertices[rank]], rank);
        }
        n_vertices += vertices.size();
      }
      EXPECT_EQ(n_vertices, mesh.positions.size());
      for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        ASSERT_LT(block_of_face[f], partition.n_blocks());
        for (const Index v : mesh.faces[f]) {
          EXPECT_TRUE(partition.is_shared[v] != 0 || block_of_face[f] == partition.block_of[v]);
        }
      }
    }
  }
}

TEST(Partition, HasBlocksOfAboutTheSizeAskedForAndDependsOnTheMeshAlone) {
  const IndexedMesh mesh = blob(6, 1);
  const WorkingSurface surface = surface_of(mesh);
  const Partition partition = make_partition(surface, 1000, 0.5, 1);
  EXPECT_GE(partition.n_blocks(), 64U);
  for (std::size_t block = 0; block < partition.n_blocks(); ++block) {
    EXPECT_LT(partition.faces.of(block).size(), 2500U);
    EXPECT_GT(partition.faces.of(block).size(), 250U);
  }
  const Partition other = make_partition(surface, 1000, 0.5, 3);
  EXPECT_EQ(partition.block_of, other.block_of);
  EXPECT_EQ(partition.is_shared, other.is_shared);
  for (std::size_t block = 0; block < partition.n_blocks(); ++block) {
    EXPECT_TRUE(std::ranges::equal(partition.faces.of(block), other.faces.of(block)));
  }
  const Partition shifted = make_partition(surface, 1000, 0.3, 1);
  std::size_t n_shared_in_both = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    n_shared_in_both += partition.is_shared[v] != 0 && shifted.is_shared[v] != 0 ? 1 : 0;
  }
  EXPECT_LT(n_shared_in_both,
            static_cast<std::size_t>(std::count(partition.is_shared.begin(), partition.is_shared.end(), 1)) / 2);
}

TEST(CostLadder, ClimbsInSmallStepsNearTheGoalAndEnds) {
  for (const double area : {0.0, 1e-12, 1e-3}) {
    CostLadder ladder(area);
    EXPECT_GT(ladder.cost(), 0);
    double last = ladder.cost();
    EXPECT_FALSE(ladder.climb(1)) << "few enough are left";
    for (const double excess : {10.0, 3.0, 1.1}) {
      EXPECT_TRUE(ladder.climb(excess));
      EXPECT_GT(ladder.cost(), last);
      EXPECT_LE(ladder.cost(), (excess < 2 ? 1.2 : 4) * last);
      last = ladder.cost();
    }
    int n = 0;
    while (ladder.climb(2)) ASSERT_LT(++n, 2000) << "where nothing can be contracted";
  }
}

}  // namespace
}  // namespace whittle::test
