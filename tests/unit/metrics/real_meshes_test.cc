// Counts of real meshes as other tools report them; skipped if the meshes are absent.
#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "support/meshes.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::metrics {
namespace {

struct Known {
  std::string file;
  std::size_t components, boundary_edges, nonmanifold_edges, nonmanifold_vertices, misoriented_edges;
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

INSTANTIATE_TEST_SUITE_P(Metrics, RealMesh,
                         testing::Values(Known{"bunny.obj", 1, 0, 0, 0, 0},                    //
                                         Known{"bones.off", 26, 0, 0, 0, 0},                   //
                                         Known{"greek_helmet.obj", 7, 424, 0, 0, 0},           //
                                         Known{"bun_zipper.ply", 1, 223, 0, 0, 0},             //
                                         Known{"mech-holes-shark.off", 1, 304, 0, 0, 0},       //
                                         Known{"boeing.off", 122, 2714, 0, 0, 0},              //
                                         Known{"cycloidal.ply", 100, 0, 242, 26, 0},           //
                                         Known{"nasty/oblong-shuffled.off", 1, 6, 0, 0, 623},  //
                                         Known{"nasty/triple_vierbein.obj", 1, 60, 20, 0, 3},  //
                                         Known{"nasty/hourglass_ico.obj", 1, 0, 0, 1, 0},      //
                                         Known{"nasty/fan3.obj", 1, 6, 1, 0, 0},               //
                                         Known{"nasty/moebius.obj", 1, 112, 0, 0, 4},          //
                                         Known{"nasty/nonmanifold_cubes.obj", 1, 6, 0, 1, 0},  //
                                         Known{"dragon_vrip.ply", 151, 4270, 0, 0, 0}));

/// A known number for a file.
struct Count {
  std::string file;
  long value;
};

std::ostream& operator<<(std::ostream& out, const Count& count) { return out << count.file; }

class RealMeshGenus : public testing::TestWithParam<Count> {};

TEST_P(RealMeshGenus, IsTheKnownOne) {
  WHITTLE_REAL_MESH_OR_SKIP(path, GetParam().file);
  EXPECT_EQ(topology(io::read_mesh(path).mesh).genus, GetParam().value);
}

INSTANTIATE_TEST_SUITE_P(Metrics, RealMeshGenus,
                         testing::Values(Count{"bunny.obj", 0}, Count{"bones.off", 0}, Count{"kitten.obj", 1},
                                         Count{"rocker.obj", 1}, Count{"joint.off", 2}, Count{"block.obj", 3}));

class RealMeshSelfIntersections : public testing::TestWithParam<Count> {};

/// Manifold triangle meshes without coincident vertices. CGAL treats coincident vertices as different.
TEST_P(RealMeshSelfIntersections, AreAsManyAsCgalFinds) {
  WHITTLE_REAL_MESH_OR_SKIP(path, GetParam().file);
  EXPECT_EQ(self_intersections(io::read_mesh(path).mesh).size(), static_cast<std::size_t>(GetParam().value));
}

INSTANTIATE_TEST_SUITE_P(Metrics, RealMeshSelfIntersections,
                         testing::Values(Count{"bunny.obj", 0}, Count{"triceratops.off", 0}, Count{"Arma.obj", 7},
                                         Count{"block.obj", 37}, Count{"bones.off", 366}));

}  // namespace
}  // namespace whittle::metrics
