// Counts of real meshes as others have them, where these meshes are at hand.
#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>

#include "support/meshes.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::metrics {
namespace {

struct Known {
  std::string file;
  std::size_t components, boundary_edges, nonmanifold_edges, nonmanifold_vertices, misoriented_edges;
  /// Faces that share no more than a corner or edge by number but intersect, as CGAL 5.5 counts them; none where the
  /// mesh has coincident vertices, which it takes for different ones, or isn't manifold.
  std::optional<std::size_t> self_intersections;
};

std::ostream& operator<<(std::ostream& out, const Known& known) { return out << known.file; }

class RealMesh : public testing::TestWithParam<Known> {};

TEST_P(RealMesh, HasTheKnownTopology) {
  const Known& known = GetParam();
  WHITTLE_REAL_MESH_OR_SKIP(path, known.file);
  const IndexedMesh mesh = io::read_mesh(path, {.weld = false}).mesh;
  const Topology t = topology(mesh);
  EXPECT_EQ(t.components, known.components);
  EXPECT_EQ(t.boundary_edges, known.boundary_edges);
  EXPECT_EQ(t.nonmanifold_edges, known.nonmanifold_edges);
  EXPECT_EQ(t.nonmanifold_vertices, known.nonmanifold_vertices);
  EXPECT_EQ(t.misoriented_edges, known.misoriented_edges);
  EXPECT_EQ(t.closed, known.boundary_edges == 0);
  EXPECT_EQ(t.manifold, known.nonmanifold_edges + known.nonmanifold_vertices == 0);
}

TEST_P(RealMesh, HasTheKnownSelfIntersections) {
  const Known& known = GetParam();
  if (!known.self_intersections) GTEST_SKIP() << "nothing to compare " << known.file << " with";
  WHITTLE_REAL_MESH_OR_SKIP(path, known.file);
  EXPECT_EQ(self_intersections(io::read_mesh(path, {.weld = false}).mesh).size(), *known.self_intersections);
}

INSTANTIATE_TEST_SUITE_P(
    Metrics, RealMesh,
    testing::Values(Known{"bunny.obj", 1, 0, 0, 0, 0, 0},             //
                    Known{"triceratops.off", 1, 0, 0, 0, 0, 0},       //
                    Known{"Arma.obj", 1, 0, 0, 0, 0, 7},              //
                    Known{"block.obj", 1, 0, 0, 0, 0, 37},            //
                    Known{"bones.off", 26, 0, 0, 0, 0, 366},          //
                    Known{"greek_helmet.obj", 7, 424, 0, 0, 0, 239},  //
                    Known{"bun_zipper.ply", 1, 223, 0, 0, 0, {}}, Known{"mech-holes-shark.off", 1, 304, 0, 0, 0, {}},
                    Known{"boeing.off", 122, 2714, 0, 0, 0, {}}, Known{"cycloidal.ply", 100, 0, 242, 26, 0, {}},
                    Known{"nasty/oblong-shuffled.off", 1, 6, 0, 0, 623, {}},
                    Known{"nasty/triple_vierbein.obj", 1, 60, 20, 0, 3, {}},
                    Known{"nasty/hourglass_ico.obj", 1, 0, 0, 1, 0, {}}, Known{"nasty/fan3.obj", 1, 6, 1, 0, 0, {}},
                    Known{"nasty/moebius.obj", 1, 112, 0, 0, 4, {}},
                    Known{"nasty/nonmanifold_cubes.obj", 1, 6, 0, 1, 0, {}},
                    Known{"dragon_vrip.ply", 151, 4270, 0, 0, 0, {}}));

TEST(RealMeshes, HaveTheKnownGenus) {
  const std::pair<const char*, long> known[] = {{"block.obj", 3},  {"joint.off", 2}, {"kitten.obj", 1},
                                                {"rocker.obj", 1}, {"bunny.obj", 0}, {"bones.off", 0}};
  for (const auto& [file, genus] : known) {
    WHITTLE_REAL_MESH_OR_SKIP(path, file);
    EXPECT_EQ(topology(io::read_mesh(path).mesh).genus, genus) << file;
  }
}

}  // namespace
}  // namespace whittle::metrics
