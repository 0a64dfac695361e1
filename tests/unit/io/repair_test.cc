#include "whittle/io/repair.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"

namespace whittle::io {
namespace {

using whittle::test::Random;

IndexedMesh random_faces(std::uint64_t seed, Index vertices, std::size_t faces) {
  Random random(seed);
  IndexedMesh mesh;
  for (Index v = 0; v < vertices; ++v) {
    mesh.positions.emplace_back(v, 0, 0);
    mesh.colors.push_back({static_cast<float>(v) / 100.F, 0, 0, 1});
  }
  for (std::size_t f = 0; f < faces; ++f) {
    Triangle face;
    for (Index& v : face) v = static_cast<Index>(random.below(vertices));
    mesh.faces.push_back(face);
    mesh.face_groups.push_back(static_cast<Index>(f));
  }
  mesh.face_attributes.push_back({.name = "number", .values = {mesh.face_groups.begin(), mesh.face_groups.end()}});
  return mesh;
}

// `random_faces` stores each face's number in its group and an attribute.
void expect_attributes_follow(const IndexedMesh& mesh, const std::string& what) {
  ASSERT_EQ(mesh.face_groups.size(), mesh.faces.size()) << what;
  EXPECT_EQ(mesh.face_attributes[0].values, std::vector<double>(mesh.face_groups.begin(), mesh.face_groups.end()))
      << what;
}

TEST(DropDegenerateFaces, AgreesWithBruteForce) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    IndexedMesh mesh = random_faces(seed, 5, 40);
    std::vector<Triangle> expected;
    for (const Triangle& face : mesh.faces) {
      if (has_three_corners(face)) expected.push_back(face);
    }
    EXPECT_EQ(drop_degenerate_faces(mesh), 40 - expected.size()) << "seed " << seed;
    EXPECT_EQ(mesh.faces, expected) << "seed " << seed;
    expect_attributes_follow(mesh, "seed " + std::to_string(seed));
  }
}

TEST(DropDegenerateFaces, KeepsFacesWithoutAreaThatHaveThreeVertices) {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.faces = {{0, 1, 2}};
  EXPECT_EQ(drop_degenerate_faces(mesh), 0U);
}

bool are_duplicates(const Triangle& a, const Triangle& b) {
  return a == b || a == Triangle{b[1], b[2], b[0]} || a == Triangle{b[2], b[0], b[1]};
}

TEST(DropDuplicateFaces, AgreesWithBruteForce) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    IndexedMesh mesh = random_faces(seed, 5, 60);
    drop_degenerate_faces(mesh);
    const std::size_t before = mesh.faces.size();
    std::vector<Triangle> expected;
    for (const Triangle& face : mesh.faces) {
      const bool is_new = std::none_of(expected.begin(), expected.end(),
                                       [&](const Triangle& other) { return are_duplicates(face, other); });
      if (is_new) expected.push_back(face);
    }
    EXPECT_EQ(drop_duplicate_faces(mesh), before - expected.size()) << "seed " << seed;
    EXPECT_EQ(mesh.faces, expected) << "seed " << seed;
    expect_attributes_follow(mesh, "seed " + std::to_string(seed));
  }
}

TEST(DropDuplicateFaces, KeepsCoincidentFacesThatLookToOppositeSides) {
  IndexedMesh mesh = whittle::test::pillow();
  EXPECT_EQ(drop_duplicate_faces(mesh), 0U);
  EXPECT_EQ(mesh.faces.size(), 2U);
}

TEST(Repair, DropsIsolatedVerticesAndRemembersOrigins) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    IndexedMesh mesh = random_faces(seed, 40, 12);
    drop_degenerate_faces(mesh);
    drop_duplicate_faces(mesh);
    const IndexedMesh before = mesh;
    std::set<Index> used;
    for (const Triangle& face : mesh.faces) used.insert(face.begin(), face.end());
    EXPECT_EQ(repair(mesh, false).isolated_vertices, 40 - used.size()) << "seed " << seed;
    EXPECT_EQ(mesh.origins, std::vector<Index>(used.begin(), used.end())) << "seed " << seed;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      EXPECT_EQ(mesh.positions[v], before.positions[mesh.origins[v]]);
      EXPECT_EQ(mesh.colors[v], before.colors[mesh.origins[v]]);
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(mesh.origins[mesh.faces[f][c]], before.faces[f][c]);
    }
  }
}

TEST(Repair, LeavesSoundMeshesAsTheyAre) {
  std::vector<whittle::test::NamedMesh> meshes = whittle::test::closed_meshes();
  for (whittle::test::NamedMesh& open : whittle::test::open_meshes()) meshes.push_back(std::move(open));
  meshes.push_back({"two_cubes_on_an_edge(2)", whittle::test::two_cubes_on_an_edge(2)});
  meshes.push_back({"three_faces_on_an_edge()", whittle::test::three_faces_on_an_edge()});
  meshes.push_back({"bow_tie()", whittle::test::bow_tie()});
  for (const auto& [name, original] : meshes) {
    if (name.starts_with("soup")) continue;
    IndexedMesh mesh = original;
    const Repairs repairs = repair(mesh);
    EXPECT_FALSE(repairs.any()) << name << ": " << to_string(repairs);
    EXPECT_EQ(mesh.faces, original.faces) << name;
    EXPECT_EQ(mesh.positions, original.positions) << name;
  }
}

TEST(Repair, CountsEachKind) {
  IndexedMesh mesh = whittle::test::with_duplicate_faces(whittle::test::soup(whittle::test::cube()), 3);
  mesh.faces.push_back({0, 0, 1});
  mesh.positions.emplace_back(9, 9, 9);
  const Repairs repairs = repair(mesh);
  EXPECT_EQ(repairs.welded_vertices, 36U - 8U);
  EXPECT_EQ(repairs.degenerate_faces, 1U);
  EXPECT_EQ(repairs.duplicate_faces, 3U);
  EXPECT_EQ(repairs.isolated_vertices, 1U);
  EXPECT_EQ(to_string(repairs), "welded 28 vertices, dropped 1 degenerate face, 3 duplicate faces, 1 isolated vertex");
  EXPECT_EQ(whittle::test::topology(mesh), whittle::test::topology(whittle::test::cube()));
}

TEST(Repair, WeldsOnlyWhenAsked) {
  IndexedMesh mesh = whittle::test::soup(whittle::test::cube());
  EXPECT_FALSE(repair(mesh, false).any());
  EXPECT_EQ(mesh.positions.size(), 36U);
}

TEST(Repair, NamesItsKindsAsTheReportDoes) {
  const Repairs repairs{.welded_vertices = 1,
                        .triangulated_polygons = 2,
                        .degenerate_faces = 3,
                        .duplicate_faces = 4,
                        .isolated_vertices = 5};
  std::string text;
  for (const auto& [name, count] : repairs.entries()) text += std::string(name) + '=' + std::to_string(count) + ' ';
  EXPECT_EQ(text,
            "welded_vertices=1 triangulated_polygons=2 degenerate_faces=3 duplicate_faces=4 isolated_vertices=5 ");
  EXPECT_EQ(to_string(Repairs{}), "");
  EXPECT_FALSE(Repairs{}.any());
  EXPECT_TRUE(repairs.any());
}

}  // namespace
}  // namespace whittle::io
