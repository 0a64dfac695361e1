// Welding joins positions. Corners keep their attributes.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "attribute_tools.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/border_gaps.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {
namespace {

using test::bits_at_corner;
using test::cube_with_charts;
using test::tube_with_seam;
using whittle::test::Random;

/// Gives vertices random attributes out of few values, so that some of those at a position are equal.
void add_random_attributes(IndexedMesh& mesh, Random& random) {
  const std::size_t n = mesh.positions.size();
  if (random.below(2) == 0) {
    for (std::size_t v = 0; v < n; ++v) mesh.normals.push_back({0, random.below(2) == 0 ? 1.F : -1.F, 0});
  }
  if (random.below(2) == 0) {
    for (std::size_t v = 0; v < n; ++v) mesh.colors.push_back({random.below(2) == 0 ? 0.F : -0.F, 0.5F, 1, 1});
  }
  for (std::size_t i = random.below(3); i > 0; --i) {
    Attribute attribute{.name = "a", .n_components = i, .values = {}};
    for (std::size_t v = 0; v < i * n; ++v) attribute.values.push_back(static_cast<double>(random.below(2)));
    mesh.attributes.push_back(std::move(attribute));
  }
  Attribute number{.name = "number", .kind = AttributeKind::category, .values = {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) number.values.push_back(static_cast<double>(f));
  mesh.face_attributes.push_back(std::move(number));
}

/// Few positions, many vertices, some faces degenerate or there twice.
IndexedMesh random_mesh(Random& random) {
  const auto n_positions = 4 + random.below(12);
  const auto n_vertices = static_cast<Index>(n_positions + random.below(60));
  IndexedMesh mesh;
  for (Index v = 0; v < n_vertices; ++v)
    mesh.positions.emplace_back(static_cast<double>(random.below(n_positions)), 0, 0);
  for (Vec3& p : mesh.positions) p = {p.x(), std::floor(p.x() / 3), std::floor(p.x() / 5)};
  for (std::size_t f = 0; f < 5 + random.below(60); ++f) {
    Triangle face{};
    for (Index& v : face) v = static_cast<Index>(random.below(n_vertices));
    mesh.faces.push_back(face);
  }
  return mesh;
}

/// \param after repaired; its face attribute "number" says which face of `before` each was
void expect_corners_kept(const IndexedMesh& before, const IndexedMesh& after, const std::string& what) {
  for (std::size_t f = 0; f < after.faces.size(); ++f) {
    const auto was = static_cast<std::size_t>(after.face_attributes.back().values[f]);
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(after.positions[after.faces[f][c]], before.positions[before.faces[was][c]]) << what;
      ASSERT_EQ(bits_at_corner(after, f, c), bits_at_corner(before, was, c)) << what << ", face " << was;
    }
  }
}

/// No vertex has two wedges with equal values, each wedge has a corner, and there is a table only if one is needed.
void expect_fewest_wedges(const IndexedMesh& mesh, const std::string& what) {
  std::map<Index, std::map<std::vector<std::uint64_t>, Index>> wedges_of;
  std::set<Index> used;
  bool has_several = false;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      auto& wedges = wedges_of[mesh.faces[f][c]];
      const Index w = mesh.wedge(f, c);
      used.insert(w);
      const auto [known, is_new] = wedges.try_emplace(bits_at_corner(mesh, f, c), w);
      ASSERT_EQ(known->second, w) << what << ": two wedges with equal values at vertex " << mesh.faces[f][c];
      has_several = has_several || wedges.size() > 1;
    }
  }
  EXPECT_EQ(used.size(), n_wedges(mesh)) << what;
  EXPECT_EQ(!mesh.wedges.empty(), has_several) << what;
}

TEST(WeldAttributes, KeepsTheValuesOfEveryCorner) {
  std::size_t n_seamed = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    Random random(seed);
    IndexedMesh before = random_mesh(random);
    add_random_attributes(before, random);
    IndexedMesh after = before;
    repair(after, seed % 8 != 0);
    const std::string what = "seed " + std::to_string(seed);
    if (after.faces.empty()) continue;
    expect_corners_kept(before, after, what);
    expect_fewest_wedges(after, what);
    n_seamed += !after.wedges.empty();
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(n_seamed, 1000U);
}

TEST(WeldAttributes, ChangesNoPositionAndNoFace) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Random random(seed);
    IndexedMesh plain = random_mesh(random);
    IndexedMesh rich = plain;
    add_random_attributes(rich, random);
    std::vector<Index> joined_plain;
    std::vector<Index> joined_rich;
    const Repairs repairs = repair(plain, true, &joined_plain);
    EXPECT_EQ(to_string(repair(rich, true, &joined_rich)), to_string(repairs)) << "seed " << seed;
    EXPECT_EQ(joined_rich, joined_plain) << "seed " << seed;
    EXPECT_EQ(rich.positions, plain.positions) << "seed " << seed;
    EXPECT_EQ(rich.faces, plain.faces) << "seed " << seed;
    EXPECT_TRUE(plain.wedges.empty()) << "seed " << seed;
  }
}

TEST(WeldAttributes, MakesNoTableWhereAllValuesAreEqual) {
  IndexedMesh mesh = whittle::test::soup(whittle::test::torus(12, 8));
  for (const Vec3& p : mesh.positions) {
    mesh.normals.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 0});
    mesh.colors.push_back({static_cast<float>(p.z()), 0, 0, 1});
  }
  const IndexedMesh before = mesh;
  repair(mesh);
  EXPECT_TRUE(mesh.wedges.empty());
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(mesh.normals[v], before.normals[mesh.origins[v]]);
    EXPECT_EQ(mesh.colors[v], before.colors[mesh.origins[v]]);
  }
}

TEST(WeldAttributes, GivesACubeAWedgeForEachSideAtACorner) {
  IndexedMesh mesh = cube_with_charts();
  EXPECT_EQ(repair(mesh).welded_vertices, 16U);
  EXPECT_EQ(mesh.positions.size(), 8U);
  EXPECT_EQ(n_wedges(mesh), 24U);
  EXPECT_EQ(seam_edges(mesh).size(), 12U);
}

TEST(WeldAttributes, GivesATubeTwoWedgesAlongItsSeam) {
  IndexedMesh mesh = tube_with_seam(12, 5);
  EXPECT_EQ(repair(mesh).welded_vertices, 6U);
  EXPECT_EQ(mesh.positions.size(), 72U);
  EXPECT_EQ(n_wedges(mesh), 78U);
  EXPECT_EQ(seam_edges(mesh).size(), 5U);
}

TEST(WeldAttributes, KeepsCornersWhereGapsAreWelded) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    IndexedMesh before = whittle::test::soup(whittle::test::blob(2, seed));
    for (Vec3& p : before.positions) p += 1e-9 * Vec3(random.uniform(), random.uniform(), random.uniform());
    add_random_attributes(before, random);
    IndexedMesh after = before;
    EXPECT_GT(weld_gaps(after, 1e-7).welded_vertices, 0U);
    const std::string what = "seed " + std::to_string(seed);
    expect_fewest_wedges(after, what);
    for (std::size_t f = 0; f < after.faces.size(); ++f) {
      const auto was = static_cast<std::size_t>(after.face_attributes.back().values[f]);
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_EQ(bits_at_corner(after, f, c), bits_at_corner(before, was, c)) << what;
    }
  }
}

TEST(WeldAttributes, LeavesOneValueAVertexWhenAskedTo) {
  const std::string ply = test::written(cube_with_charts(), Format::ply);
  const ReadResult all = test::read(ply, "a.ply");
  const ReadResult one = test::read_per_vertex(ply, "a.ply");
  EXPECT_FALSE(all.mesh.wedges.empty());
  EXPECT_TRUE(one.mesh.wedges.empty());
  EXPECT_TRUE(one.mesh.attributes.empty());
  EXPECT_EQ(one.mesh.positions, all.mesh.positions);
  EXPECT_EQ(one.mesh.faces, all.mesh.faces);
  ASSERT_EQ(one.mesh.normals.size(), 8U);
  for (std::size_t v = 0; v < 8; ++v) {
    EXPECT_EQ(one.mesh.normals[v], cube_with_charts().normals[one.mesh.origins[v]]) << "the lowest vertex's";
  }
}

}  // namespace
}  // namespace whittle::io
