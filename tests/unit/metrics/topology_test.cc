#include "whittle/metrics/topology.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"

namespace whittle::metrics {

bool operator==(const Topology& a, const Topology& b);
bool operator==(const Topology& a, const Topology& b) {
  return a.vertices == b.vertices && a.faces == b.faces && a.edges == b.edges &&
         a.collapsed_faces == b.collapsed_faces && a.boundary_edges == b.boundary_edges &&
         a.boundary_loops == b.boundary_loops && a.nonmanifold_edges == b.nonmanifold_edges &&
         a.nonmanifold_vertices == b.nonmanifold_vertices && a.misoriented_edges == b.misoriented_edges &&
         a.components == b.components && a.euler == b.euler && a.manifold == b.manifold && a.closed == b.closed &&
         a.oriented == b.oriented && a.orientable == b.orientable && a.genus == b.genus;
}

std::ostream& operator<<(std::ostream& out, const Topology& t);
std::ostream& operator<<(std::ostream& out, const Topology& t) {
  out << "vertices " << t.vertices << ", edges " << t.edges << ", faces " << t.faces << ", collapsed "
      << t.collapsed_faces << ", boundary " << t.boundary_edges << " in " << t.boundary_loops << ", nonmanifold edges "
      << t.nonmanifold_edges << ", vertices " << t.nonmanifold_vertices << ", misoriented " << t.misoriented_edges
      << ", components " << t.components << ", euler " << t.euler << ", manifold " << t.manifold << ", closed "
      << t.closed << ", oriented " << t.oriented << ", orientable " << t.orientable << ", genus ";
  return t.genus ? out << *t.genus : out << "none";
}

namespace {

using test::Random;

/// The number of connected sets of items. Two items are connected if they share a key. \param keys the keys of each
/// item
std::size_t count_sets(const std::vector<std::vector<std::size_t>>& keys) {
  std::map<std::size_t, std::vector<std::size_t>> holders;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (const std::size_t key : keys[i]) holders[key].push_back(i);
  }
  std::vector<bool> seen(keys.size(), false);
  std::size_t sets = 0;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (seen[i]) continue;
    ++sets;
    std::vector<std::size_t> open{i};
    seen[i] = true;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const std::size_t key : keys[at]) {
        for (const std::size_t next : holders[key]) {
          if (!seen[next]) open.push_back(next);
          seen[next] = true;
        }
      }
    }
  }
  return sets;
}

/// The topology by its definitions, with sets, maps and flood fill.
class ByDefinition {
 public:
  explicit ByDefinition(const IndexedMesh& mesh) {
    for (const Triangle& face : mesh.faces) {
      if (std::set<Index>(face.begin(), face.end()).size() < 3) {
        ++result_.collapsed_faces;
      } else {
        faces_.push_back(face);
      }
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Index from = faces_[f][c], to = faces_[f][(c + 1) % 3];
        edges_[std::minmax(from, to)].emplace_back(f, from < to);
        stars_[from].insert(f);
      }
    }
  }

  Topology topology() {
    result_.vertices = stars_.size();
    result_.faces = faces_.size();
    result_.edges = edges_.size();
    result_.euler =
        static_cast<long>(stars_.size()) - static_cast<long>(edges_.size()) + static_cast<long>(faces_.size());
    find_fans();
    count_components();
    count_edges();
    orient();
    result_.oriented = result_.misoriented_edges == 0;
    result_.closed = result_.faces > 0 && result_.boundary_edges == 0;
    result_.manifold = result_.nonmanifold_edges + result_.nonmanifold_vertices + result_.collapsed_faces == 0;
    if (result_.manifold && result_.closed && result_.orientable) {
      result_.genus = static_cast<long>(result_.components) - result_.euler / 2;
    }
    return result_;
  }

 private:
  using Edge = std::pair<Index, Index>;

  /// Numbers the fan of each face at each vertex, by flooding over the edges at the vertex.
  void find_fans() {
    std::size_t n_fans = 0;
    for (const auto& [vertex, star] : stars_) {
      const std::size_t first = n_fans;
      for (const std::size_t seed : star) {
        if (fan_.count({vertex, seed}) == 0) flood_fan(vertex, seed, n_fans++);
      }
      if (n_fans - first > 1) ++result_.nonmanifold_vertices;
    }
  }
  void flood_fan(Index vertex, std::size_t seed, std::size_t number) {
    std::vector<std::size_t> open{seed};
    fan_[{vertex, seed}] = number;
    while (!open.empty()) {
      const std::size_t f = open.back();
      open.pop_back();
      for (const Index other : faces_[f]) {
        if (other == vertex) continue;
        for (const auto& [g, up] : edges_[std::minmax(vertex, other)]) {
          if (fan_.emplace(std::pair{vertex, g}, number).second) open.push_back(g);
        }
      }
    }
  }

  void count_components() {
    std::vector<std::vector<std::size_t>> face_vertices;
    for (const Triangle& face : faces_) face_vertices.emplace_back(face.begin(), face.end());
    result_.components = count_sets(face_vertices);
  }

  void count_edges() {
    std::vector<std::vector<std::size_t>> boundary_fans;
    for (const auto& [edge, around] : edges_) {
      if (around.size() == 1) {
        ++result_.boundary_edges;
        const std::size_t f = around[0].first;
        boundary_fans.push_back({fan_[{edge.first, f}], fan_[{edge.second, f}]});
      }
      if (around.size() > 2) ++result_.nonmanifold_edges;
      if (around.size() == 2 && around[0].second == around[1].second) ++result_.misoriented_edges;
    }
    result_.boundary_loops = count_sets(boundary_fans);
  }

  /// Reverses faces one after the other to match their neighbours. After a contradiction there is no orientation.
  void orient() {
    std::map<std::size_t, bool> reversed;
    for (std::size_t seed = 0; seed < faces_.size(); ++seed) {
      if (!reversed.emplace(seed, false).second) continue;
      std::vector<std::size_t> open{seed};
      while (!open.empty()) {
        const std::size_t f = open.back();
        open.pop_back();
        for (std::size_t c = 0; c < 3; ++c) {
          const auto& around = edges_[std::minmax(faces_[f][c], faces_[f][(c + 1) % 3])];
          if (around.size() != 2) continue;
          const std::size_t g = around[0].first == f ? around[1].first : around[0].first;
          const bool wanted = reversed[f] != (around[0].second == around[1].second);
          const auto [known, is_new] = reversed.emplace(g, wanted);
          if (is_new) open.push_back(g);
          if (known->second != wanted) result_.orientable = false;
        }
      }
    }
  }

  Topology result_;
  std::vector<Triangle> faces_;
  std::map<Edge, std::vector<std::pair<std::size_t, bool>>> edges_;  ///< faces; true if from lower to higher vertex
  std::map<Index, std::set<std::size_t>> stars_;
  std::map<std::pair<Index, std::size_t>, std::size_t> fan_;  ///< number of the fan of a vertex and a face
};

Topology by_definition(const IndexedMesh& mesh) { return ByDefinition(mesh).topology(); }

/// nu × nv squares with opposite sides joined, one pair of sides reversed: a Klein bottle. The positions are those of a
/// flat square; only the vertex numbers matter.
IndexedMesh klein_bottle(Index nu, Index nv) {
  IndexedMesh mesh;
  for (Index u = 0; u < nu; ++u) {
    for (Index v = 0; v < nv; ++v) mesh.positions.emplace_back(u, v, 0.0);
  }
  const auto at = [&](Index u, Index v) { return u < nu ? u * nv + v % nv : (nv - v % nv) % nv; };
  for (Index u = 0; u < nu; ++u) {
    for (Index v = 0; v < nv; ++v) {
      mesh.faces.push_back({at(u, v), at(u + 1, v), at(u + 1, v + 1)});
      mesh.faces.push_back({at(u, v), at(u + 1, v + 1), at(u, v + 1)});
    }
  }
  return mesh;
}

/// The projective plane with the fewest vertices: the icosahedron with opposite points identified.
IndexedMesh projective_plane() {
  IndexedMesh mesh;
  mesh.positions.resize(6, Vec3::Zero());
  mesh.faces = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  return mesh;
}

TEST(Topology, OfATetrahedron) {
  const Topology t = topology(test::tetrahedron());
  EXPECT_EQ(t.vertices, 4U);
  EXPECT_EQ(t.edges, 6U);
  EXPECT_EQ(t.faces, 4U);
  EXPECT_EQ(t.euler, 2);
  EXPECT_EQ(t.genus, 0);
  EXPECT_TRUE(t.manifold && t.closed && t.oriented && t.orientable) << t;
}

TEST(Topology, GenusOfHandles) {
  EXPECT_EQ(topology(test::sphere(2)).genus, 0);
  EXPECT_EQ(topology(test::torus(12, 8)).genus, 1);
  EXPECT_EQ(topology(test::csaszar_torus()).genus, 1);
  EXPECT_EQ(topology(test::bracket(3)).genus, 1);
}

TEST(Topology, GenusOfSeveralPartsIsTheirSum) {
  const Topology t = topology(test::joined(test::torus(12, 8), test::joined(test::torus(5, 4), test::cube())));
  EXPECT_EQ(t.components, 3U);
  EXPECT_EQ(t.euler, 2);
  EXPECT_EQ(t.genus, 2);
}

TEST(Topology, OfOpenSurfaces) {
  const Topology disk = topology(test::grid(5, 4));
  EXPECT_EQ(disk.boundary_edges, 18U);
  EXPECT_EQ(disk.boundary_loops, 1U);
  EXPECT_EQ(disk.euler, 1);
  EXPECT_TRUE(disk.manifold && !disk.closed) << disk;
  EXPECT_FALSE(disk.genus.has_value());
  const Topology tube = topology(test::open_cylinder(12, 5));
  EXPECT_EQ(tube.boundary_edges, 24U);
  EXPECT_EQ(tube.boundary_loops, 2U);
  EXPECT_EQ(tube.euler, 0);
}

TEST(Topology, OfSurfacesWithoutTwoSides) {
  const Topology strip = topology(test::moebius(20, 2));
  EXPECT_FALSE(strip.orientable);
  EXPECT_FALSE(strip.oriented);
  EXPECT_EQ(strip.boundary_loops, 1U);
  EXPECT_EQ(strip.euler, 0);

  const Topology bottle = topology(klein_bottle(5, 4));
  EXPECT_TRUE(bottle.manifold && bottle.closed) << bottle;
  EXPECT_FALSE(bottle.orientable);
  EXPECT_EQ(bottle.euler, 0);
  EXPECT_FALSE(bottle.genus.has_value());

  const Topology plane = topology(projective_plane());
  EXPECT_TRUE(plane.manifold && plane.closed) << plane;
  EXPECT_FALSE(plane.orientable);
  EXPECT_EQ(plane.euler, 1);
}

TEST(Topology, SurvivesFacesTurnedOver) {
  for (const auto& [name, mesh] : test::closed_meshes()) {
    const Topology before = topology(mesh);
    IndexedMesh mixed = mesh;
    for (std::size_t f = 0; f < mixed.faces.size(); f += 3) std::swap(mixed.faces[f][0], mixed.faces[f][1]);
    const Topology after = topology(mixed);
    EXPECT_TRUE(after.orientable) << name;
    EXPECT_FALSE(after.oriented) << name;
    EXPECT_GT(after.misoriented_edges, 0U) << name;
    EXPECT_EQ(after.genus, before.genus) << name;
  }
}

TEST(Topology, OfABowTie) {
  const Topology solid = topology(test::bow_tie());
  EXPECT_EQ(solid.nonmanifold_vertices, 1U);
  EXPECT_EQ(solid.nonmanifold_edges, 0U);
  EXPECT_EQ(solid.components, 1U);
  EXPECT_TRUE(solid.closed && !solid.manifold) << solid;
  EXPECT_FALSE(solid.genus.has_value());

  IndexedMesh flat;  // two triangles with one common corner
  flat.positions.resize(5, Vec3::Zero());
  flat.faces = {{0, 1, 2}, {0, 3, 4}};
  const Topology open = topology(flat);
  EXPECT_EQ(open.nonmanifold_vertices, 1U);
  EXPECT_EQ(open.boundary_loops, 2U);
}

TEST(Topology, OfEdgesWithManyFaces) {
  const Topology three = topology(test::three_faces_on_an_edge());
  EXPECT_EQ(three.nonmanifold_edges, 1U);
  EXPECT_EQ(three.nonmanifold_vertices, 0U);
  EXPECT_EQ(three.boundary_edges, 6U);
  EXPECT_FALSE(three.manifold);
  const Topology cubes = topology(test::two_cubes_on_an_edge());
  EXPECT_EQ(cubes.nonmanifold_edges, 1U);
  EXPECT_EQ(cubes.boundary_edges, 0U);
  EXPECT_TRUE(cubes.closed && !cubes.manifold) << cubes;
}

TEST(Topology, LeavesCollapsedFacesOut) {
  IndexedMesh mesh = test::cube();
  Topology expected = topology(mesh);
  mesh.positions.emplace_back(5.0, 5.0, 5.0);
  mesh.faces.push_back({8, 8, 0});
  mesh.faces.push_back({1, 1, 1});
  expected.collapsed_faces = 2;
  expected.manifold = false;
  expected.genus.reset();
  EXPECT_EQ(topology(mesh), expected);
}

TEST(Topology, OfNothing) {
  const Topology t = topology(IndexedMesh{});
  EXPECT_EQ(t.components, 0U);
  EXPECT_FALSE(t.closed);
  EXPECT_FALSE(t.genus.has_value());
}

TEST(Topology, DoesNotCountUnusedVertices) {
  EXPECT_EQ(topology(test::with_isolated_vertices(test::torus(8, 6), 20, 4)), topology(test::torus(8, 6)));
}

TEST(Topology, RejectsMissingVertices) {
  IndexedMesh mesh = test::cube();
  mesh.faces[7][1] = 8;
  EXPECT_THROW(topology(mesh), std::invalid_argument);
}

TEST(Topology, AgreesWithItsDefinitionOnNamedMeshes) {
  for (const auto& [name, mesh] : test::all_meshes()) EXPECT_EQ(topology(mesh), by_definition(mesh)) << name;
  EXPECT_EQ(topology(klein_bottle(4, 5)), by_definition(klein_bottle(4, 5)));
  EXPECT_EQ(topology(test::pillow()), by_definition(test::pillow()));
}

TEST(Topology, AgreesWithItsDefinitionOnRandomFaces) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    IndexedMesh mesh;
    const std::uint64_t n_vertices = 4 + random.below(12), n_faces = 1 + random.below(30);
    mesh.positions.resize(n_vertices, Vec3::Zero());
    for (std::uint64_t f = 0; f < n_faces; ++f) {
      Triangle face{};
      for (Index& v : face) v = static_cast<Index>(random.below(n_vertices));
      mesh.faces.push_back(face);
    }
    ASSERT_EQ(topology(mesh), by_definition(mesh)) << "seed " << seed;
  }
}

TEST(Topology, AgreesWithItsDefinitionOnTornMeshes) {
  for (const auto& [name, mesh] : test::closed_meshes()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      IndexedMesh torn = mesh;
      Random random(seed);
      std::erase_if(torn.faces, [&](const Triangle&) { return random.below(4) == 0; });
      ASSERT_EQ(topology(torn), by_definition(torn)) << name << ", seed " << seed;
    }
  }
}

TEST(Topology, AgreesWithTheOracleOfTheTestSupport) {
  for (const auto& [name, mesh] : test::closed_meshes()) {
    const Topology t = topology(mesh);
    const test::Topology oracle = test::topology(mesh);
    EXPECT_EQ(t.euler, oracle.euler()) << name;
    EXPECT_EQ(t.genus, oracle.genus()) << name;
    EXPECT_EQ(t.components, static_cast<std::size_t>(oracle.components)) << name;
  }
}

TEST(Topology, DoesNotDependOnTheOrder) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      EXPECT_EQ(topology(test::permuted(mesh, seed).mesh), topology(mesh)) << name << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace whittle::metrics
