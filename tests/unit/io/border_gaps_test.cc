#include "whittle/io/border_gaps.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"

namespace whittle::io {
namespace {

using whittle::test::NamedMesh;
using whittle::test::Random;
using whittle::test::soup;
using whittle::test::Topology;
using whittle::test::topology;

/// Moves every vertex by at most `size` along each axis.
IndexedMesh jittered(IndexedMesh mesh, double size, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : mesh.positions) p += random.uniform_vector(-size, size);
  return mesh;
}

double shortest_edge(const IndexedMesh& mesh) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Triangle& face : mesh.faces) {
    for (std::size_t c = 0; c < 3; ++c) {
      shortest = std::min(shortest, (mesh.positions[face[c]] - mesh.positions[face[(c + 1) % 3]]).norm());
    }
  }
  return shortest;
}

std::size_t n_edges_with_more_than_two_faces(const IndexedMesh& mesh) {
  std::map<std::set<Index>, int> faces;
  for (const Triangle& face : mesh.faces) {
    for (std::size_t c = 0; c < 3; ++c) ++faces[{face[c], face[(c + 1) % 3]}];
  }
  std::size_t count = 0;
  for (const auto& [edge, n] : faces) count += n > 2;
  return count;
}

std::vector<NamedMesh> clean_meshes() {
  std::vector<NamedMesh> meshes = whittle::test::closed_meshes();
  for (const NamedMesh& open : whittle::test::open_meshes()) meshes.push_back(open);
  return meshes;
}

TEST(BorderGaps, AreFoundWhereCornersWereRounded) {
  for (const auto& [name, mesh] : clean_meshes()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(find_border_gaps(mesh).n_vertices, 0U);
    IndexedMesh exact = soup(mesh);
    repair(exact);
    EXPECT_EQ(find_border_gaps(exact).n_vertices, 0U);
    if (mesh.faces.size() == 1) continue;
    const double size = 1e-4 * shortest_edge(mesh);
    const BorderGaps gaps = find_border_gaps(jittered(soup(mesh), size, 7));
    EXPECT_GT(gaps.n_vertices, mesh.faces.size());
    EXPECT_LE(gaps.widest, 2 * std::sqrt(3.0) * size * (1 + 1e-6));
  }
}

TEST(BorderGaps, AreClosedAsIfNothingHadBeenRounded) {
  for (const auto& [name, mesh] : clean_meshes()) {
    SCOPED_TRACE(name);
    IndexedMesh exact = soup(mesh);
    repair(exact);
    IndexedMesh welded = jittered(soup(mesh), 1e-4 * shortest_edge(mesh), 11);
    const IndexedMesh before = welded;
    const Repairs done = weld_gaps(welded, find_border_gaps(welded).tolerance());
    EXPECT_EQ(done.welded_vertices, before.positions.size() - welded.positions.size());
    EXPECT_EQ(done.isolated_vertices, 0U);
    EXPECT_EQ(welded.positions.size(), exact.positions.size());
    const Topology found = topology(welded);
    const Topology expected = topology(exact);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(find_border_gaps(welded).n_vertices, 0U);
  }
}

TEST(BorderGaps, StayWhereWeldingWouldSpoilTheMesh) {
  std::size_t n_welded = 0;
  for (const auto& [name, mesh] : clean_meshes()) {
    for (const double share : {1e-5, 0.3, 1.0, 10.0, 1e6}) {
      SCOPED_TRACE(name + ", tolerance " + std::to_string(share) + " of the shortest edge");
      const double tolerance = share * shortest_edge(mesh);
      const IndexedMesh before = jittered(soup(mesh), 0.1 * shortest_edge(mesh), 5);
      IndexedMesh after = before;
      std::vector<Index> map;
      const Repairs done = weld_gaps(after, tolerance, &map);
      n_welded += done.welded_vertices;
      EXPECT_EQ(n_edges_with_more_than_two_faces(after), 0U);
      for (const Triangle& face : after.faces) EXPECT_TRUE(has_three_corners(face));
      ASSERT_EQ(map.size(), before.positions.size());
      for (std::size_t v = 0; v < map.size(); ++v) {
        if (map[v] == invalid_index && done.duplicate_faces > 0) continue;  // was in a face laid on another one
        ASSERT_NE(map[v], invalid_index);
        const double moved = (after.positions[map[v]] - before.positions[v]).norm();
        EXPECT_LE(moved, 2 * tolerance * (1 + 1e-9));
      }
      for (std::size_t f = 0; f < after.faces.size() && after.faces.size() == before.faces.size(); ++f) {
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(after.faces[f][c], map[before.faces[f][c]]);
      }
    }
  }
  EXPECT_GT(n_welded, 1000U);
}

TEST(BorderGaps, DoNotDependOnTheUnit) {
  const IndexedMesh mesh = jittered(soup(whittle::test::torus(12, 8)), 1e-6, 3);
  for (const int exponent : {-500, 400}) {
    IndexedMesh scaled = mesh;
    for (Vec3& p : scaled.positions) p *= std::ldexp(1.0, exponent);
    const BorderGaps gaps = find_border_gaps(scaled);
    EXPECT_EQ(gaps.n_vertices, find_border_gaps(mesh).n_vertices);
    EXPECT_EQ(gaps.widest, std::ldexp(find_border_gaps(mesh).widest, exponent));
    IndexedMesh welded = mesh;
    weld_gaps(welded, find_border_gaps(mesh).tolerance());
    weld_gaps(scaled, gaps.tolerance());
    EXPECT_EQ(scaled.faces, welded.faces);
  }
}

TEST(BorderGaps, RefuseAToleranceThatIsNoLength) {
  IndexedMesh mesh = whittle::test::grid(3, 3);
  EXPECT_THROW(weld_gaps(mesh, -1), std::invalid_argument);
  EXPECT_THROW(weld_gaps(mesh, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(weld_gaps(mesh, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::io
