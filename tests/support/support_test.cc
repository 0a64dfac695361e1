#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <ostream>
#include <stdexcept>

#include "support/meshes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

// The counts that the header promises -----------------------------------------------------------------------------

struct Promise {
  std::string name;
  IndexedMesh mesh;
  int vertices;
  int faces;
  int genus;

  friend std::ostream& operator<<(std::ostream& out, const Promise& promise) { return out << promise.name; }
};

class ClosedShape : public testing::TestWithParam<Promise> {};

TEST_P(ClosedShape, HasThePromisedCountsAndFacesOutwards) {
  const auto& [name, mesh, vertices, faces, genus] = GetParam();
  const Topology t = topology(mesh);
  EXPECT_EQ(mesh.positions.size(), static_cast<std::size_t>(vertices)) << name;
  EXPECT_EQ(t.vertices, vertices) << name << ": a vertex that no face uses";
  EXPECT_EQ(t.faces, faces) << name;
  EXPECT_EQ(t.genus(), genus) << name << ' ' << t;
  EXPECT_TRUE(t.closed() && t.manifold()) << name << ' ' << t;
  EXPECT_EQ(t.misoriented_edges, 0) << name;
  EXPECT_EQ(t.components, 1) << name;
  EXPECT_GT(signed_volume(mesh), 0) << name;
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ClosedShape,
    testing::Values(Promise{"tetrahedron", tetrahedron(), 4, 4, 0}, Promise{"octahedron", octahedron(), 6, 8, 0},
                    Promise{"icosahedron", icosahedron(), 12, 20, 0}, Promise{"cube", cube(), 8, 12, 0},
                    Promise{"csaszar_torus", csaszar_torus(), 7, 14, 1},
                    Promise{"tessellated_cube_1", tessellated_cube(1), 8, 12, 0},
                    Promise{"tessellated_cube_7", tessellated_cube(7), 296, 588, 0},
                    Promise{"sphere_3", sphere(3), 642, 1280, 0}, Promise{"uv_sphere", uv_sphere(9, 20), 162, 320, 0},
                    Promise{"uv_sphere_least", uv_sphere(2, 3), 5, 6, 0}, Promise{"torus", torus(9, 5), 45, 90, 1},
                    Promise{"noisy_torus", noisy_torus(20, 10, 1, 0.4, 0.05, 1), 200, 400, 1},
                    Promise{"noisy_sphere", noisy_sphere(2, 0.1, 1), 162, 320, 0},
                    Promise{"blob", blob(3, 1), 642, 1280, 0}, Promise{"knot", knot(48, 6), 288, 576, 1},
                    Promise{"cone", cone(17), 19, 34, 0}, Promise{"frustum", frustum(17), 36, 68, 0},
                    Promise{"bracket_2", bracket(2), 66, 132, 1}, Promise{"bracket_5", bracket(5), 312, 624, 1}),
    [](const auto& one) { return one.param.name; });

TEST(OpenShape, HasThePromisedCounts) {
  struct Case {
    const char* name;
    IndexedMesh mesh;
    int vertices, faces, loops, euler;
  };
  for (const Case& c :
       {Case{"grid", grid(4, 3), 20, 24, 1, 1}, Case{"noisy_grid", noisy_grid(4, 3, 0.2, 1), 20, 24, 1, 1},
        Case{"terrain", terrain(6, 1), 49, 72, 1, 1}, Case{"open_cylinder", open_cylinder(7, 3), 28, 42, 2, 0},
        Case{"moebius", moebius(11), 22, 22, 1, 0}, Case{"moebius wide", moebius(11, 3), 44, 66, 1, 0},
        Case{"single_triangle", single_triangle(), 3, 1, 1, 1}, Case{"two_triangles", two_triangles(), 4, 2, 1, 1}}) {
    const Topology t = topology(c.mesh);
    EXPECT_EQ(t.vertices, c.vertices) << c.name;
    EXPECT_EQ(t.faces, c.faces) << c.name;
    EXPECT_EQ(t.border_loops, c.loops) << c.name << ' ' << t;
    EXPECT_EQ(t.euler(), c.euler) << c.name << ' ' << t;
    EXPECT_TRUE(t.manifold()) << c.name << ' ' << t;
  }
}

TEST(OpenShape, OnlyTheMoebiusStripIsMisoriented) {
  for (const NamedMesh& entry : open_meshes()) {
    const bool is_moebius = entry.name.starts_with("moebius");
    EXPECT_EQ(topology(entry.mesh).misoriented_edges > 0, is_moebius) << entry.name;
  }
}

TEST(NonManifoldShape, HasThePromisedDefects) {
  const Topology bow = topology(bow_tie());
  EXPECT_EQ(bow, (Topology{.vertices = 7, .edges = 12, .faces = 8, .components = 1, .nonmanifold_vertices = 1})) << bow;
  const Topology fan = topology(three_faces_on_an_edge());
  EXPECT_EQ(fan.nonmanifold_edges, 1) << fan;
  EXPECT_EQ(fan.faces, 3) << fan;
  const Topology cubes = topology(two_cubes_on_an_edge());
  EXPECT_EQ(cubes.vertices, 14) << cubes;
  EXPECT_EQ(cubes.faces, 24) << cubes;
  EXPECT_EQ(cubes.nonmanifold_edges, 1) << cubes;
  EXPECT_DOUBLE_EQ(signed_volume(two_cubes_on_an_edge()), 16.0);
  const Topology cut = topology(two_cubes_on_an_edge(4));
  EXPECT_EQ(cut.vertices, 12 * 16 - 4 + 3) << cut;
  EXPECT_EQ(cut.faces, 24 * 16) << cut;
  EXPECT_EQ(cut.nonmanifold_edges, 4) << cut;
  const Topology pages = topology(book(7, 3));
  EXPECT_EQ(pages.vertices, 4 * 15) << pages;
  EXPECT_EQ(pages.faces, 4 * 7 * 3) << pages;
  EXPECT_EQ(pages.nonmanifold_edges, 3) << pages;
  EXPECT_EQ(pages.components, 1) << pages;
  const Topology flat = topology(pillow());
  EXPECT_TRUE(flat.closed() && flat.manifold()) << flat;
  EXPECT_EQ(flat.euler(), 2) << flat;
  for (const NamedMesh& entry : nonmanifold_meshes()) EXPECT_FALSE(topology(entry.mesh).manifold()) << entry.name;
}

TEST(SpoiledShape, HasThePromisedDefects) {
  const Topology unshared = topology(soup(cube()));
  EXPECT_EQ(unshared.vertices, 36) << unshared;
  EXPECT_EQ(unshared.components, 12) << unshared;
  EXPECT_EQ(topology(glued(soup(blob(1, 4)))), topology(blob(1, 4)));
  const IndexedMesh twice = with_duplicate_faces(cube(), 12);
  EXPECT_EQ(topology(twice).nonmanifold_edges, 18);
  EXPECT_EQ(twice.faces.size(), 24u);
  const IndexedMesh sparse = with_isolated_vertices(cube(), 5, 3);
  EXPECT_EQ(sparse.positions.size(), 13u);
  EXPECT_EQ(topology(sparse), topology(cube()));
  EXPECT_DOUBLE_EQ(signed_volume(sparse), 8.0);
  EXPECT_DOUBLE_EQ(signed_volume(inside_out(cube())), -8.0);
}

TEST(SeveralParts, AreCountedApart) {
  EXPECT_EQ(topology(spheres(3, 1)).components, 3);
  EXPECT_EQ(topology(boxes(3, 2)).components, 6);
  EXPECT_EQ(topology(boxes(3, 2)).genus(), 0);
  EXPECT_EQ(topology(joined(torus(5, 5), csaszar_torus())).genus(), 2);
}

// Measures ----------------------------------------------------------------------------------------------------------

TEST(Shape, HasTheVolumeOfItsClosedForm) {
  EXPECT_DOUBLE_EQ(signed_volume(cube()), 8.0);
  EXPECT_NEAR(surface_area(tessellated_cube(5)), 24.0, 1e-12);
  EXPECT_NEAR(signed_volume(tetrahedron()), 8.0 / 3, 1e-12);
  EXPECT_NEAR(signed_volume(csaszar_torus()), 125.0, 1e-12);
  // A polygon of n = 200 corners replaces a circle. It is too small by a factor of about 2π²/(3n²), 1.6e-4.
  EXPECT_NEAR(signed_volume(cone(200)) / (2 * std::numbers::pi / 3), 1, 2e-4);
  const double pi2 = std::numbers::pi * std::numbers::pi;
  EXPECT_NEAR(signed_volume(torus(200, 200)) / (2 * pi2 * 0.35 * 0.35), 1, 1e-3);
  EXPECT_NEAR(signed_volume(sphere(5)) / (4 * std::numbers::pi / 3), 1, 2e-3);
  // Plate 2 × 2 × 0.25 without the 4n-gon of the hole; wall 0.25 × 2 × 2.
  EXPECT_NEAR(signed_volume(bracket(30)), 1.0 - 0.25 * std::numbers::pi * 0.25 + 1.0, 1e-3);
}

TEST(Shape, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const std::function<IndexedMesh(std::uint64_t)> makers[] = {
      [](std::uint64_t seed) { return noisy_grid(5, 5, 0.1, seed); }, [](std::uint64_t s) { return terrain(5, s); },
      [](std::uint64_t seed) { return noisy_torus(5, 5, 1, 0.3, 0.1, seed); },
      [](std::uint64_t seed) { return blob(2, seed); }};
  for (std::size_t i = 0; i < std::size(makers); ++i) {
    EXPECT_EQ(makers[i](4).positions, makers[i](4).positions) << "maker " << i;
    EXPECT_NE(makers[i](4).positions, makers[i](5).positions) << "maker " << i;
  }
}

TEST(Blob, KeepsToItsRadii) {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const Vec3& p : blob(3, seed).positions) {
      ASSERT_GE(p.norm(), 0.6) << "seed " << seed;
      ASSERT_LE(p.norm(), 1.6) << "seed " << seed;
    }
}

TEST(UvSphere, HasPolesOfHighValence) {
  const IndexedMesh mesh = uv_sphere(6, 40);
  const auto pole = static_cast<Index>(mesh.positions.size() - 1);
  EXPECT_EQ(std::ranges::count_if(mesh.faces, [&](const Triangle& f) { return f[0] == pole; }), 40);
}

TEST(Shape, RefusesImpossibleArguments) {
  EXPECT_THROW(grid(0, 1), std::invalid_argument);
  EXPECT_THROW(torus(2, 5), std::invalid_argument);
  EXPECT_THROW(uv_sphere(1, 5), std::invalid_argument);
  EXPECT_THROW(sphere(-1), std::invalid_argument);
  EXPECT_THROW(bracket(1), std::invalid_argument);
  EXPECT_THROW(moebius(4), std::invalid_argument);
  EXPECT_THROW(with_duplicate_faces(cube(), 13), std::invalid_argument);
}

// The C++ standard gives the ten-thousandth number of std::mt19937_64. This test checks our own scaling of it.
TEST(Random, IsTheSameEverywhere) {
  Random random(5489);
  for (int i = 0; i < 9999; ++i) random.bits();
  EXPECT_EQ(random.bits(), 9981545732273789042u);
  Random uniform(5489);
  EXPECT_EQ(uniform.uniform(), static_cast<double>(14514284786278117030u >> 11) * 0x1p-53);
}

// Transformations ---------------------------------------------------------------------------------------------------

TEST(Rotated, KeepsEveryDistance) {
  const IndexedMesh mesh = blob(2, 9);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const IndexedMesh turned = rotated(mesh, seed);
    EXPECT_NEAR(signed_volume(turned), signed_volume(mesh), 1e-12) << "seed " << seed;
    EXPECT_NEAR((turned.positions[3] - turned.positions[90]).norm(), (mesh.positions[3] - mesh.positions[90]).norm(),
                1e-12);
    EXPECT_GT((turned.positions[3] - mesh.positions[3]).norm(), 1e-3) << "seed " << seed;
  }
  const Vec3 quarter = rotated(cube(), {0, 0, 5}, 90).positions[0];
  EXPECT_LT((quarter - Vec3(1, -1, -1)).norm(), 1e-12);
}

TEST(Scaled, AndMovedChangeTheDiagonalAsTheyShould) {
  EXPECT_DOUBLE_EQ(diagonal(cube()), 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(diagonal(scaled(cube(), 1024)), 2048 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(diagonal(moved(cube(), {100, 0, 0})), diagonal(cube()));
  EXPECT_EQ(moved(cube(), {100, 0, 0}).positions[0].x(), 99);
  EXPECT_EQ(diagonal(IndexedMesh{}), 0);
}

TEST(Permuted, SaysWhereEverythingWentAndTakesAttributesAlong) {
  IndexedMesh mesh = blob(1, 2);
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    mesh.normals.push_back({static_cast<float>(v), 0, 0});
    mesh.colors.push_back({0, static_cast<float>(v), 0, 1});
  }
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    mesh.face_groups.push_back(f % 3);
  }
  mesh.attributes.push_back({.name = "uv", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}});
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    for (const double number : {1.0 * v, 2.0 * v}) mesh.attributes[0].values.push_back(number);
  }
  const auto [out, old_vertex, old_face] = permuted(mesh, 77);
  ASSERT_EQ(out.positions.size(), mesh.positions.size());
  ASSERT_EQ(out.faces.size(), mesh.faces.size());
  EXPECT_EQ(topology(out), topology(mesh));
  EXPECT_NE(out.positions, mesh.positions);
  EXPECT_THAT(old_vertex, testing::Not(testing::WhenSorted(testing::ContainerEq(old_vertex))));
  for (Index v = 0; v < out.positions.size(); ++v) {
    EXPECT_EQ(out.positions[v], mesh.positions[old_vertex[v]]);
    EXPECT_EQ(out.normals[v], mesh.normals[old_vertex[v]]);
    EXPECT_EQ(out.colors[v], mesh.colors[old_vertex[v]]);
    EXPECT_EQ(out.attributes[0].value(v)[1], 2.0 * old_vertex[v]);
  }
  for (Index f = 0; f < out.faces.size(); ++f) {
    EXPECT_EQ(out.face_groups[f], mesh.face_groups[old_face[f]]);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(old_vertex[out.faces[f][i]], mesh.faces[old_face[f]][i]);
    }
  }
}

// Suites and files --------------------------------------------------------------------------------------------------

TEST(Suites, HoldWhatTheirNamesSay) {
  for (const NamedMesh& entry : closed_meshes()) {
    const Topology t = topology(entry.mesh);
    EXPECT_TRUE(t.closed() && t.manifold() && t.misoriented_edges == 0) << entry.name << ' ' << t;
    EXPECT_LE(t.faces, 1000) << entry.name;
  }
  for (const NamedMesh& entry : open_meshes()) {
    const Topology t = topology(entry.mesh);
    EXPECT_TRUE(!t.closed() && t.manifold()) << entry.name << ' ' << t;
  }
  EXPECT_EQ(all_meshes().size(), closed_meshes().size() + open_meshes().size() + nonmanifold_meshes().size());
}

TEST(Topology, CountsDegenerateFacesAndLeavesThemOut) {
  IndexedMesh mesh = cube();
  mesh.faces.push_back({0, 0, 1});
  const Topology t = topology(mesh);
  EXPECT_EQ(t.degenerate_faces, 1);
  EXPECT_EQ(t.euler(), 2) << t;
  EXPECT_TRUE(t.closed()) << t;
}

TEST(RealMesh, IsNothingWhereTheFileIsAbsent) { EXPECT_FALSE(real_mesh("no such mesh.obj").has_value()); }

}  // namespace
}  // namespace whittle::test
