#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "decimated.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "surface/line_samples.hh"
#include "surface/mesh_lines.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/metrics/line_distance.hh"

// Borders and feature lines, which are fitted to those of the original.
namespace whittle::test {

using namespace polishing;

namespace {

constexpr double feature_angle_deg = 40;

/// A sheet whose border is curved in space.
IndexedMesh wavy_sheet(int n) {
  IndexedMesh mesh = grid(n, n);
  for (Vec3& p : mesh.positions) {
    const Vec3 q = p / n;
    p = Vec3(q.x() + 0.1 * std::sin(7 * q.y()), q.y() + 0.1 * std::sin(6 * q.x()),
             0.2 * std::sin(5 * q.x() + 4 * q.y()));
  }
  return mesh;
}

/// A cube with bent edges.
IndexedMesh bent_cube(int n) {
  IndexedMesh mesh = tessellated_cube(n);
  for (Vec3& p : mesh.positions) {
    p += 0.15 * Vec3(std::sin(3 * p.y() + p.z()), std::sin(3 * p.z() + p.x()), std::sin(3 * p.x() + p.y()));
  }
  return mesh;
}

metrics::LineDistance border_distance(const IndexedMesh& a, const IndexedMesh& b) {
  return metrics::line_distance(metrics::border_lines(a), metrics::border_lines(b)).value();
}

metrics::LineDistance feature_distance(const IndexedMesh& a, const IndexedMesh& b) {
  return metrics::line_distance(metrics::feature_lines(a, feature_angle_deg),
                                metrics::feature_lines(b, feature_angle_deg))
      .value();
}

TEST(MeshLines, KnowTheEdgesAtAVertex) {
  const std::vector<VertexPair> borders{{0, 1}, {1, 2}};
  const std::vector<VertexPair> features{{1, 3}};
  const std::vector<VertexPair> seams{{3, 2}};
  const MeshLines lines(borders, features, seams, 5);
  EXPECT_EQ(lines.at(0).size(), 1U);
  ASSERT_EQ(lines.at(1).size(), 3U);
  for (const Index e : lines.at(1)) EXPECT_TRUE(lines.edges()[e].from == 1 || lines.edges()[e].to == 1);
  EXPECT_EQ(lines.edges()[lines.at(2)[0]].kind, LineKind::border);
  EXPECT_EQ(lines.edges()[lines.at(2)[1]].kind, LineKind::seam);
  EXPECT_EQ(lines.edges()[lines.at(3)[0]].kind, LineKind::feature);
  EXPECT_TRUE(lines.at(4).empty());
}

/// A bent line over a straight edge. A function that is linear on each of its edges is integrated exactly.
TEST(LineSamples, WeighWhatTheLinesHaveOfLength) {
  const std::vector<Vec3> bent{Vec3(0, 0, 0), Vec3(1, 0.1, 0), Vec3(3, -0.2, 0.1), Vec3(4, 0.1, 0)};
  const std::vector<VertexPair> bent_edges{{0, 1}, {1, 2}, {2, 3}};
  IndexedMesh straight;
  straight.positions = {Vec3(-1, 0, 0), Vec3(5, 0, 0), Vec3(0, 5, 0)};
  straight.faces = {{0, 1, 2}};
  const std::vector<VertexPair> straight_edges{{0, 1}};
  const MeshLines lines(straight_edges, {}, {}, 3);
  const std::vector<Index> map{0, 0, 1, 1};
  LineSamples samples(MeshLines(bent_edges, {}, {}, 4), bent, map);
  const VertexCorners corners = corners_by_vertex(straight.faces, straight.positions.size());
  const Surface mesh{straight.faces, corners, straight.positions};
  samples.find_closest_points(lines, mesh, 2);
  double weight = 0;
  double squares = 0;
  samples.for_each_closest_point([&](const ClosestLinePoint& closest, double w) {
    EXPECT_EQ(closest.edge, 0U);
    EXPECT_NEAR(closest.offset.x(), 0, 1e-12);
    weight += w;
    squares += w * closest.offset.squaredNorm();
  });
  double length = 0;
  double integral = 0;
  for (const auto& [a, b] : bent_edges) {
    const double edge = (bent[b] - bent[a]).norm();
    const auto height = [&](Index v) { return Vec3(0, bent[v].y(), bent[v].z()); };
    length += edge;
    integral += edge / 3 * (height(a).squaredNorm() + height(a).dot(height(b)) + height(b).squaredNorm());
  }
  EXPECT_NEAR(weight, length, 1e-12);
  EXPECT_NEAR(squares, integral, 1e-12);
}

TEST(LineSamples, FindOnlyLinesOfTheirKindThatRunTheirWay) {
  const IndexedMesh mesh = grid(1, 1);
  const VertexCorners corners = corners_by_vertex(mesh.faces, mesh.positions.size());
  const Surface surface{mesh.faces, corners, mesh.positions};
  const std::vector<VertexPair> edge{{0, 1}};
  const std::vector<Index> map{0, 0};
  const auto count = [&](const MeshLines& from, const MeshLines& to, const std::vector<Vec3>& positions) {
    LineSamples samples(from, positions, map);
    samples.find_closest_points(to, surface, 1);
    int n = 0;
    samples.for_each_closest_point([&n](const ClosestLinePoint&, double) { ++n; });
    return n;
  };
  const Vec3 a = mesh.positions[0];
  const Vec3 way = mesh.positions[1] - a;
  const Vec3 up = Vec3(0, 0, way.norm());
  const MeshLines border(edge, {}, {}, 4);
  const MeshLines feature({}, edge, {}, 4);
  const MeshLines seam({}, {}, edge, 4);
  EXPECT_EQ(count(border, border, {a, a + way}), 2);
  EXPECT_EQ(count(feature, feature, {a, a - way}), 4) << "two without weight";
  EXPECT_EQ(count(seam, seam, {a, a - way}), 2);
  EXPECT_EQ(count(border, feature, {a, a + way}), 0);
  EXPECT_EQ(count(seam, feature, {a, a + way}), 0);
  EXPECT_EQ(count(border, border, {a, a + up}), 0);
}

TEST(PolishLines, AreBroughtNearerOnBorders) {
  for (const IndexedMesh& original : {wavy_sheet(40), terrain(40, 7), open_cylinder(60, 30)}) {
    for (const double ratio : {0.5, 0.1, 0.03}) {
      SCOPED_TRACE(ratio);
      const Decimation d = decimated(original, ratio);
      const auto before = border_distance(original, d.mesh);
      for (const unsigned passes : {1U, 3U}) {
        const auto after = border_distance(original, polished(original, d, {.passes = passes}));
        EXPECT_LE(after.mean, 0.9 * before.mean + 1e-9);
        EXPECT_LE(after.max, 1.001 * before.max + 1e-9);
      }
    }
  }
}

TEST(PolishLines, StayWhereTheyAreRight) {
  const IndexedMesh original = wavy_sheet(30);
  DecimateOptions locked;
  locked.cost = Cost::memoryless;
  locked.boundary = Boundary::locked;
  const Decimation d = decimate(original, DecimateTarget::faces(500), locked);
  const IndexedMesh after = polished(original, d);
  EXPECT_LT(border_distance(original, after).max, 1e-9);
  EXPECT_NE(after.positions, d.mesh.positions);
}

TEST(PolishLines, AreTheSameForAnyThreadsAndUnit) {
  const IndexedMesh original = wavy_sheet(40);
  const Decimation d = decimated(original, 0.1);
  const IndexedMesh one = polished(original, d, {.passes = 2, .threads = 1});
  EXPECT_EQ(polished(original, d, {.passes = 2, .threads = 3}).positions, one.positions);
  Decimation large = d;
  large.mesh = scaled(d.mesh, 1024);
  const IndexedMesh scaled_up = polished(scaled(original, 1024), large, {.passes = 2});
  for (std::size_t v = 0; v < one.positions.size(); ++v) EXPECT_EQ(scaled_up.positions[v], 1024 * one.positions[v]);
}

TEST(PolishLines, MayBeNamedWrong) {
  const IndexedMesh original = wavy_sheet(10);
  const Decimation d = decimated(original, 0.5);
  IndexedMesh mesh = d.mesh;
  const std::vector<VertexPair> no_vertex{{0, 1000}};
  EXPECT_THROW(polish(original, d.vertex_map, mesh, {.features = no_vertex}), std::invalid_argument);
  EXPECT_THROW(polish(original, d.vertex_map, mesh, {.original_features = no_vertex}), std::invalid_argument);
  for (const double angle : {0.0, -1.0, 180.0, std::nan("")}) {
    EXPECT_THROW(polish(original, d.vertex_map, mesh, {.feature_angle_deg = angle}), std::invalid_argument);
  }
  EXPECT_THROW(polish(original, d.vertex_map, mesh, {.seams = no_vertex}), std::invalid_argument);
  EXPECT_THROW(polish(original, d.vertex_map, mesh, {.original_seams = no_vertex}), std::invalid_argument);
  for (const double wrong : {-1.0, std::nan("")}) {
    EXPECT_THROW(polish(original, d.vertex_map, mesh, {.feature_tolerance = wrong}), std::invalid_argument);
    EXPECT_THROW(polish(original, d.vertex_map, mesh, {.seam_weight = wrong}), std::invalid_argument);
    EXPECT_THROW(polish(original, d.vertex_map, mesh, {.shape_weight = wrong}), std::invalid_argument);
  }
  EXPECT_EQ(mesh.positions, d.mesh.positions);
  const auto n = static_cast<Index>(mesh.positions.size());
  const std::vector<VertexPair> no_edge{{0, n - 1}, {0, 0}, detail::border_edges(mesh.faces, n)[0]};
  EXPECT_EQ(polished(original, d, {.features = no_edge}).positions, polished(original, d).positions);
}

TEST(PolishLines, StayIfToldSo) {
  const IndexedMesh original = wavy_sheet(30);
  const Decimation d = decimated(original, 0.1);
  const IndexedMesh fitted = polished(original, d);
  const IndexedMesh kept = polished(original, d, {.fit_borders = false});
  std::size_t n_moved = 0;
  for (const auto& [v, next] : detail::border_edges(d.mesh.faces, d.mesh.positions.size())) {
    EXPECT_EQ(kept.positions[v], d.mesh.positions[v]);
    n_moved += static_cast<std::size_t>(fitted.positions[v] != d.mesh.positions[v]);
  }
  EXPECT_GT(n_moved, 10U);
  EXPECT_NE(kept.positions, d.mesh.positions);
}

TEST(PolishLines, AreBroughtNearerOnFeaturesWhichStayTheSame) {
  const IndexedMesh original = bent_cube(24);
  const std::vector<VertexPair> original_features = feature_edges(original, feature_angle_deg);
  for (const double ratio : {0.5, 0.2}) {
    SCOPED_TRACE(ratio);
    const Decimation d = decimated(original, ratio, {.feature_angle_deg = feature_angle_deg});
    const IndexedMesh after = polished(original, d,
                                       {.passes = 3,
                                        .feature_angle_deg = feature_angle_deg,
                                        .features = d.feature_edges,
                                        .original_features = original_features});
    EXPECT_EQ(feature_edges(after, feature_angle_deg), feature_edges(d.mesh, feature_angle_deg));
    EXPECT_LT(feature_distance(original, after).mean, 0.97 * feature_distance(original, d.mesh).mean);
    EXPECT_LE(feature_distance(original, after).max, 1.001 * feature_distance(original, d.mesh).max);
    std::vector<int> n_lines(after.positions.size());
    for (const auto& [a, b] : d.feature_edges) ++n_lines[a], ++n_lines[b];
    std::size_t n_moved = 0;
    for (std::size_t v = 0; v < n_lines.size(); ++v) {
      const bool is_moved = after.positions[v] != d.mesh.positions[v];
      EXPECT_FALSE(is_moved && n_lines[v] > 2);
      n_moved += static_cast<std::size_t>(n_lines[v] == 2 && is_moved);
    }
    EXPECT_GT(n_moved, 10U);
  }
}

TEST(PolishLines, MakeNoOtherEdgesSharp) {
  const IndexedMesh original = noisy_torus(80, 40, 1, 0.4, 0.02, 3);
  const std::vector<VertexPair> original_features = feature_edges(original, feature_angle_deg);
  const Decimation d = decimated(original, 0.3, {.feature_angle_deg = feature_angle_deg});
  const PolishOptions options{
      .feature_angle_deg = feature_angle_deg, .features = d.feature_edges, .original_features = original_features};
  const auto sharp = feature_edges(d.mesh, feature_angle_deg);
  EXPECT_EQ(feature_edges(polished(original, d, options), feature_angle_deg), sharp);
  EXPECT_NE(feature_edges(polished(original, d), feature_angle_deg), sharp) << "else this tests nothing";
}

}  // namespace
}  // namespace whittle::test
