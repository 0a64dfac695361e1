// Meshes with every kind of defect, through the whole library: repaired, simplified, judged. WHITTLE_DEFECTIVE_MESHES
// is their number, if a longer search is wanted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "support/defects.hh"
#include "whittle/io/repair.hh"
#include "whittle/metrics/topology.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

std::uint64_t n_meshes() {
  const char* asked = std::getenv("WHITTLE_DEFECTIVE_MESHES");
  return asked == nullptr ? 80 : std::strtoull(asked, nullptr, 10);
}

void expect_valid(const IndexedMesh& mesh) {
  for (const Vec3& p : mesh.positions) ASSERT_TRUE(p.allFinite());
  for (const Triangle& face : mesh.faces) {
    ASSERT_TRUE(has_three_corners(face));
    for (const Index v : face) ASSERT_LT(v, mesh.positions.size());
  }
}

void expect_total(const std::vector<Index>& map, const IndexedMesh& before, const IndexedMesh& after) {
  ASSERT_EQ(map.size(), before.positions.size());
  std::vector<bool> is_used(map.size());
  for (const Triangle& face : before.faces) {
    for (const Index v : face) is_used[v] = true;
  }
  for (std::size_t v = 0; v < map.size(); ++v) {
    if (map[v] != invalid_index) {
      ASSERT_LT(map[v], after.positions.size());
    } else {
      ASSERT_FALSE(is_used[v]) << "vertex " << v << " went nowhere";
    }
  }
}

TEST(DefectiveMeshes, ReachTheTargetOrSayWhyNot) {
  std::size_t n_met = 0;
  for (std::uint64_t seed = 0; seed < n_meshes(); ++seed) {
    auto [name, mesh] = defective_mesh(seed);
    if (seed % 2 == 0) io::repair(mesh);
    const metrics::Topology before = metrics::topology(mesh);
    const std::uint64_t n_faces = mesh.faces.size() / 10 + 1;
    for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
      SCOPED_TRACE(name + ", effort " + std::to_string(static_cast<int>(effort)));
      const Simplification result =
          simplify(mesh, DecimateTarget::faces(n_faces), effort, {.decimate = {.threads = 1}});
      expect_valid(result.mesh);
      expect_total(result.vertex_map, mesh, result.mesh);
      ASSERT_EQ(result.mesh.faces.size(), result.result.n_faces);
      if (result.result.stop == StopReason::target) {
        ++n_met;
        EXPECT_LE(result.mesh.faces.size(), n_faces);
      } else {
        EXPECT_EQ(result.result.stop, StopReason::exhausted);
        EXPECT_GT(result.result.refused_at_end.total(), 0U) << "nothing stands in the way";
      }
      const metrics::Topology after = metrics::topology(result.mesh);
      EXPECT_TRUE(!before.manifold || after.manifold);
      EXPECT_TRUE(!before.manifold || before.components == after.components);
      EXPECT_TRUE(!before.closed || after.closed);
      EXPECT_TRUE(!before.oriented || after.oriented);
      EXPECT_LE(after.misoriented_edges, before.misoriented_edges);
    }
  }
  EXPECT_GT(n_met, n_meshes()) << "of three times as many runs";
}

}  // namespace
}  // namespace whittle::test
