#include <gtest/gtest.h>

#include <iomanip>
#include <iostream>

#include "support/meshes.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/topology.hh"

// Each mesh ends at the number of faces asked for, and its topology and shape are kept.

namespace whittle::test {
namespace {

struct Case {
  std::string name;
  std::vector<double> ratios;          ///< of the vertices
  std::vector<std::uint64_t> n_faces;  ///< asked for
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Counts : public testing::TestWithParam<Case> {
 protected:
  static void expect_same_surface(const metrics::Topology& before, const metrics::Topology& after) {
    EXPECT_TRUE(after.closed);
    EXPECT_EQ(after.genus, before.genus);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.nonmanifold_edges, before.nonmanifold_edges);
    if (before.manifold) {
      EXPECT_TRUE(after.manifold);
    }
    if (before.manifold && before.genus == 0 && before.components == 1) {
      EXPECT_EQ(after.faces, 2 * after.vertices - 4);
    }
  }
};

TEST_P(Counts, AreThoseAskedForAndTheSurfaceStays) {
  WHITTLE_REAL_MESH_OR_SKIP(path, GetParam().name);
  const IndexedMesh mesh = io::read_mesh(path).mesh;
  const metrics::Topology before = metrics::topology(mesh);
  ASSERT_TRUE(before.closed);
  std::cout << GetParam().name << ": " << before.vertices << " vertices, " << before.faces << " faces\n";
  const auto check = [&](const DecimateTarget& target, std::uint64_t asked, const char* what) {
    SCOPED_TRACE(std::to_string(asked) + what);
    const Decimation d = decimate(mesh, target);
    const metrics::Topology after = metrics::topology(d.mesh);
    std::cout << "  asked for " << std::setw(6) << asked << what << ": " << std::setw(6) << after.vertices
              << " vertices, " << std::setw(6) << after.faces << " faces, genus "
              << (after.genus ? std::to_string(*after.genus) : "-") << (after.closed ? ", closed" : ", OPEN") << "\n";
    EXPECT_EQ(d.result.stop, StopReason::target);
    EXPECT_EQ(after.vertices, d.result.n_vertices);
    EXPECT_EQ(after.faces, d.result.n_faces);
    expect_same_surface(before, after);
    return after;
  };
  for (const double ratio : GetParam().ratios) {
    const auto asked = static_cast<std::uint64_t>(ratio * static_cast<double>(before.vertices));
    EXPECT_EQ(check(DecimateTarget::vertices(asked), asked, " vertices").vertices, asked);
  }
  for (const std::uint64_t asked : GetParam().n_faces) {
    EXPECT_EQ(check(DecimateTarget::faces(asked), asked, " faces").faces,
              asked - asked % 2);  // closed: faces vanish in twos
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Counts,
                         testing::Values(Case{"dinosaur.obj", {0.5, 0.3, 0.1, 0.05, 0.01}, {}},
                                         Case{"bunny.obj", {0.5, 0.3, 0.1, 0.01}, {}},
                                         Case{"ankylosaurus.obj", {0.5, 0.2, 0.01}, {}}, Case{"cow.off", {}, {295}},
                                         Case{"dragon_vrip.ply", {}, {144'106}}),
                         [](const auto& test) {
                           return test.param.name.substr(0, test.param.name.find_first_of("._"));
                         });

TEST(Counts, DragonIsWhatItsWeldedFileHolds) {
  WHITTLE_REAL_MESH_OR_SKIP(path, "dragon_vrip.ply");
  const metrics::Topology t = metrics::topology(io::read_mesh(path).mesh);
  EXPECT_EQ(t.faces, 871'306U);
  EXPECT_TRUE(t.closed);
  EXPECT_TRUE(t.manifold);
}

}  // namespace
}  // namespace whittle::test
