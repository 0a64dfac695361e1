#include "whittle/core/wedges.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/detail/checks.hh"

namespace whittle::test {
namespace {

using Value = std::tuple<std::array<float, 3>, Color, std::vector<double>>;

/// All attributes at a corner.
Value value_at(const IndexedMesh& mesh, std::size_t face, std::size_t corner) {
  const Index w = mesh.wedge(face, corner);
  const auto numbers = mesh.attributes[0].value(w);
  return {mesh.normals[w], mesh.colors[w], {numbers.begin(), numbers.end()}};
}

/// Faces among a few vertices; each corner has a wedge of its own, with one of few values.
IndexedMesh random_wedges(std::uint64_t seed) {
  Random random(seed);
  IndexedMesh mesh;
  constexpr std::size_t n_vertices = 8;
  for (std::size_t v = 0; v < n_vertices; ++v) mesh.positions.push_back(random.uniform_vector(-1, 1));
  Attribute uv{.name = "uv", .kind = AttributeKind::texcoord, .n_components = 2};
  for (std::size_t f = 0; f < 20; ++f) {
    Triangle& face = mesh.faces.emplace_back();
    for (Index& v : face) {
      v = static_cast<Index>(random.below(n_vertices));
      mesh.wedges.push_back(static_cast<Index>(mesh.wedges.size()));
      mesh.normals.push_back({static_cast<float>(random.below(2)), 0, 1});
      mesh.colors.push_back({1, 1, 1, 1});
      uv.values.push_back(static_cast<double>(random.below(2)));
      uv.values.push_back(0.5);
    }
  }
  mesh.attributes.push_back(uv);
  return mesh;
}

TEST(Wedges, ThatAreEqualBecomeOneAndCornersKeepTheirValues) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const IndexedMesh mesh = random_wedges(seed);
    IndexedMesh joined = mesh;
    join_equal_wedges(joined);
    check_attributes(joined, "test");
    std::set<std::pair<Index, Value>> different;
    std::map<Index, Index> vertex_of;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(value_at(joined, f, k), value_at(mesh, f, k));
        different.insert({mesh.faces[f][k], value_at(mesh, f, k)});
        vertex_of[joined.wedge(f, k)] = joined.faces[f][k];
      }
    }
    EXPECT_EQ(n_wedges(joined), different.size()) << seed;
    EXPECT_EQ(vertex_of.size(), different.size()) << "each has a corner";
    Index before = 0;
    for (const auto& [w, v] : vertex_of) {
      EXPECT_GE(v, before) << "numbered by vertex";
      before = v;
    }
  }
}

TEST(Wedges, NeedNoTableWhereEachVertexHasOne) {
  IndexedMesh mesh = sphere(1);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.colors.push_back({static_cast<float>(v), 0, 0, 1});
  const std::vector<Color> colors = mesh.colors;
  make_wedge_table(mesh);
  EXPECT_EQ(mesh.wedges.size(), 3 * mesh.faces.size());
  join_equal_wedges(mesh);
  EXPECT_TRUE(mesh.wedges.empty());
  EXPECT_EQ(mesh.colors, colors);
}

TEST(Wedges, BecomeVerticesWithTheSameSurfaceAndValues) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const IndexedMesh mesh = random_wedges(seed);
    const IndexedMesh split = split_at_wedges(mesh);
    EXPECT_TRUE(split.wedges.empty());
    check_attributes(split, "test");
    ASSERT_EQ(split.faces.size(), mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(split.positions[split.faces[f][k]], mesh.positions[mesh.faces[f][k]]);
        EXPECT_EQ(split.origins[split.faces[f][k]], mesh.faces[f][k]);
        EXPECT_EQ(value_at(split, f, k), value_at(mesh, f, k));
      }
    }
  }
}

TEST(Wedges, AreDroppedButForOneAVertex) {
  IndexedMesh mesh = charted_cube(2);
  join_equal_wedges(mesh);
  EXPECT_EQ(n_wedges(mesh), 6U * 9);
  const IndexedMesh before = mesh;
  drop_seams(mesh);
  EXPECT_TRUE(mesh.wedges.empty());
  check_attributes(mesh, "test");
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = mesh.faces[f][k];
      std::set<std::vector<double>> there;
      for (std::size_t corner = 0; corner < before.wedges.size(); ++corner) {
        if (before.faces[corner / 3][corner % 3] != v) continue;
        const auto value = before.attributes[0].value(before.wedges[corner]);
        there.insert({value.begin(), value.end()});
      }
      const auto value = mesh.attributes[0].value(v);
      EXPECT_TRUE(there.contains({value.begin(), value.end()}));
    }
  }
}

TEST(Seams, LieBetweenChartsAndGroupsAlone) {
  const IndexedMesh cube_with_charts = charted_cube(3);
  const std::vector<VertexPair> seams = seam_edges(cube_with_charts);
  EXPECT_EQ(seams.size(), 12U * 3);
  for (const auto& [a, b] : seams) {
    const Vec3 middle = (cube_with_charts.positions[a] + cube_with_charts.positions[b]) / 2;
    EXPECT_EQ((middle.cwiseAbs().array() > 1 - 1e-12).count(), 2) << "on an edge of the cube";
  }
  IndexedMesh shaded = cube_with_charts;
  shaded.attributes.clear();
  EXPECT_EQ(seam_edges(shaded), seams) << "between groups";
  shaded.face_groups.clear();
  EXPECT_TRUE(seam_edges(shaded).empty()) << "shading may break anywhere";
  EXPECT_EQ(seam_edges(textured_torus(12, 8)).size(), 12U + 8);
}

TEST(Seams, LieWhereTheSideOfTheBitangentChanges) {
  IndexedMesh mesh = two_triangles();
  make_wedge_table(mesh);
  for (Index& w : mesh.wedges) w = static_cast<Index>(&w - mesh.wedges.data());
  Attribute tangents{.name = "TANGENT", .kind = AttributeKind::tangent, .n_components = 4};
  for (int corner = 0; corner < 6; ++corner) {
    for (const double x : {corner < 3 ? 1.0 : 0.8, 0.0, corner < 3 ? 0.0 : 0.6, 1.0}) tangents.values.push_back(x);
  }
  mesh.attributes = {tangents};
  EXPECT_TRUE(seam_edges(mesh).empty());
  for (std::size_t corner = 3; corner < 6; ++corner) mesh.attributes[0].value(corner)[3] = -1;
  EXPECT_EQ(seam_edges(mesh).size(), 1U);
}

}  // namespace
}  // namespace whittle::test
