#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "decimated.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "surface/face_neighbors.hh"
#include "surface/mesh_lines.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/core/wedges.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/nearest_vertices.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/metrics/topology.hh"

// Edge flips during polish.
namespace whittle::test {

using namespace polishing;

namespace {

std::size_t n_changed(const IndexedMesh& a, const IndexedMesh& b) {
  std::size_t n = 0;
  for (std::size_t f = 0; f < a.faces.size(); ++f) n += static_cast<std::size_t>(a.faces[f] != b.faces[f]);
  return n;
}

bool has_edge(const IndexedMesh& mesh, Index v, Index w) {
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Triangle& face) {
    return std::count(face.begin(), face.end(), v) + std::count(face.begin(), face.end(), w) == 2;
  });
}

/// Two roofs with ridges along the diagonals of their squares. One has all its edges across the ridge, the other none.
TEST(PolishFlips, LayEdgesAlongARidge) {
  std::size_t n_flips = 0;
  for (const double side : {1.0, -1.0}) {
    const auto raise = [side](IndexedMesh mesh, double step) {
      for (Vec3& p : mesh.positions) {
        p *= step;
        p.z() = -0.3 * std::abs(side > 0 ? p.x() - p.y() : p.x() + p.y() - 8);
      }
      return mesh;
    };
    const IndexedMesh original = raise(grid(64, 64), 0.125);
    const IndexedMesh coarse = raise(grid(8, 8), 1);
    const std::vector<std::uint8_t> locked(coarse.positions.size(), 1);
    IndexedMesh mesh = coarse;
    const PolishResult result =
        polish(original, metrics::nearest_vertices(original, mesh, 1), mesh, {.locked = locked, .flips = true});
    EXPECT_EQ(mesh.positions, coarse.positions);
    n_flips += n_changed(coarse, mesh) / 2;
    if (mesh.faces == coarse.faces) {
      EXPECT_LT(result.rms_before, 1e-6);
    } else {
      EXPECT_LT(result.rms_after, 0.6 * result.rms_before);
    }
  }
  EXPECT_GE(n_flips, 6U);
  EXPECT_LE(n_flips, 8U);
}

TEST(SlowPolishFlips, LessenTheError) {
  double product = 1;
  for (const IndexedMesh& original : {blob(5, 4), knot(200, 24), noisy_torus(120, 60, 1.0, 0.4, 0.01, 5)}) {
    for (const double ratio : {0.3, 0.05}) {
      const Decimation d = decimated(original, ratio);
      const auto rms = [&](bool flips) {
        return metrics::surface_distance(original, polished(original, d, {.passes = 3, .flips = flips}),
                                         {.samples = 20'000})
            .rms;
      };
      const double share = rms(true) / rms(false);
      EXPECT_LT(share, 1.01) << ratio;
      product *= share;
    }
  }
  EXPECT_LT(std::pow(product, 1.0 / 6), 0.99);
}

TEST(PolishFlips, KeepTheSurfaceWhole) {
  std::size_t n_flipped = 0;
  for (const auto& [name, original] : all_meshes()) {
    SCOPED_TRACE(name);
    const Decimation d = decimated(original, 0.4);
    if (d.mesh.faces.empty()) continue;
    const IndexedMesh after = polished(original, d, {.passes = 3, .flips = true});
    n_flipped += n_changed(d.mesh, after);
    const metrics::Topology was = metrics::topology(d.mesh);
    const metrics::Topology is = metrics::topology(after);
    EXPECT_EQ(is.faces, was.faces);
    EXPECT_EQ(is.boundary_edges, was.boundary_edges);
    EXPECT_EQ(is.nonmanifold_edges, was.nonmanifold_edges);
    EXPECT_EQ(is.nonmanifold_vertices, was.nonmanifold_vertices);
    EXPECT_EQ(is.components, was.components);
    EXPECT_EQ(is.euler, was.euler);
    EXPECT_EQ(detail::border_edges(after.faces, after.positions.size()),
              detail::border_edges(d.mesh.faces, d.mesh.positions.size()));
    EXPECT_LE(metrics::shape(after).folds, metrics::shape(d.mesh).folds);
    EXPECT_LE(metrics::self_intersections(after).size(), metrics::self_intersections(d.mesh).size());
  }
  EXPECT_GT(n_flipped, 50U);
}

TEST(PolishFlips, MakeNoVertexTooPoorOrRich) {
  const IndexedMesh original = noisy_sphere(5, 0.05, 1);
  const Decimation d = decimated(original, 0.1);
  const IndexedMesh after = polished(original, d, {.passes = 5, .flips = true});
  const metrics::ValenceStats was = metrics::shape(d.mesh).valence;
  const metrics::ValenceStats is = metrics::shape(after).valence;
  EXPECT_NE(after.faces, d.mesh.faces);
  EXPECT_GE(is.min, std::min<std::size_t>(was.min, 4));
  EXPECT_LE(is.max, std::max<std::size_t>(was.max, 9));
}

TEST(PolishFlips, LeaveFeaturesGroupsAndTextures) {
  constexpr double angle = 40;
  const IndexedMesh original = bracket(16);
  const Decimation d = decimated(original, 0.2, {.feature_angle_deg = angle});
  const std::vector<VertexPair> original_features = feature_edges(original, angle);
  const PolishOptions options{.passes = 3,
                              .flips = true,
                              .feature_angle_deg = angle,
                              .features = d.feature_edges,
                              .original_features = original_features};
  EXPECT_EQ(feature_edges(polished(original, d, options), angle), feature_edges(d.mesh, angle));

  const IndexedMesh round = noisy_sphere(4, 0.05, 1);
  Decimation grouped = decimated(round, 0.2);
  for (const Triangle& face : grouped.mesh.faces) grouped.mesh.face_groups.push_back(face[0] % 2);
  const IndexedMesh after = polished(round, grouped, {.passes = 3, .flips = true});
  EXPECT_NE(after.faces, grouped.mesh.faces);
  const VertexCorners corners = corners_by_vertex(grouped.mesh.faces, grouped.mesh.positions.size());
  const FaceNeighbors neighbors(grouped.mesh.faces, corners, detail::Workers(1));
  for (Index f = 0; f < grouped.mesh.faces.size(); ++f) {
    for (Index place = 0; place < 3; ++place) {
      if (grouped.mesh.face_groups[f] == grouped.mesh.face_groups[neighbors.beyond(f, place).face]) continue;
      const Triangle& face = grouped.mesh.faces[f];
      EXPECT_TRUE(has_edge(after, face[place], face[(place + 1) % 3]));
    }
  }
  make_wedge_table(grouped.mesh);
  EXPECT_EQ(polished(round, grouped, {.flips = true}).faces, grouped.mesh.faces);
}

TEST(PolishFlips, AreTheSameForAnyThreads) {
  const IndexedMesh original = noisy_sphere(5, 0.05, 8);
  const Decimation d = decimated(original, 0.2);
  const IndexedMesh one = polished(original, d, {.passes = 2, .flips = true, .threads = 1});
  EXPECT_NE(one.faces, d.mesh.faces);
  for (const unsigned threads : {2U, 5U}) {
    const IndexedMesh other = polished(original, d, {.passes = 2, .flips = true, .threads = threads});
    EXPECT_EQ(other.faces, one.faces);
    EXPECT_EQ(other.positions, one.positions);
  }
}

}  // namespace
}  // namespace whittle::test
