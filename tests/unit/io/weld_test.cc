#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {
namespace {

using whittle::test::NamedMesh;
using whittle::test::Random;
using whittle::test::soup;
using whittle::test::Topology;
using whittle::test::topology;

using Edge = std::array<Index, 2>;

Edge edge_of(const Triangle& face, std::size_t c) {
  const auto [a, b] = std::minmax(face[c], face[(c + 1) % 3]);
  return {a, b};
}

std::map<Edge, std::vector<std::size_t>> faces_by_edge(const std::vector<Triangle>& faces) {
  std::map<Edge, std::vector<std::size_t>> edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (!has_three_corners(faces[f])) continue;
    for (std::size_t c = 0; c < 3; ++c) edges[edge_of(faces[f], c)].push_back(f);
  }
  return edges;
}

// The vertices that may be welded, by the rule in its simplest form.
std::vector<char> candidates(const IndexedMesh& mesh) {
  std::vector<char> is_candidate(mesh.positions.size(), 0);
  for (const auto& [edge, faces] : faces_by_edge(mesh.faces)) {
    const bool has_no_length = mesh.positions[edge[0]] == mesh.positions[edge[1]];
    if (faces.size() == 1 || has_no_length) is_candidate[edge[0]] = is_candidate[edge[1]] = 1;
  }
  return is_candidate;
}

// Welds all vertices that the rule allows, even if edges get more than two faces.
std::vector<Index> weld_all(const IndexedMesh& mesh) {
  const std::vector<char> is_candidate = candidates(mesh);
  std::vector<Index> joined_to(mesh.positions.size());
  for (std::size_t v = 0; v < joined_to.size(); ++v) {
    joined_to[v] = static_cast<Index>(v);
    for (std::size_t u = 0; u < v && is_candidate[v]; ++u) {
      if (is_candidate[u] && mesh.positions[u] == mesh.positions[v]) {
        joined_to[v] = static_cast<Index>(u);
        break;
      }
    }
  }
  return joined_to;
}

// Counts edges with more than two faces that were different edges before. \param original the number that each face had
std::size_t edges_gone_wrong(const IndexedMesh& before, const std::vector<Triangle>& welded,
                             const std::vector<std::size_t>& original) {
  std::size_t wrong = 0;
  for (const auto& [edge, faces] : faces_by_edge(welded)) {
    if (faces.size() <= 2) continue;
    std::set<Edge> stored;
    for (const std::size_t f : faces) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (edge_of(welded[f], c) == edge) stored.insert(edge_of(before.faces[original[f]], c));
      }
    }
    wrong += stored.size() > 1;
  }
  return wrong;
}

std::vector<Triangle> renumbered(const std::vector<Triangle>& faces, const std::vector<Index>& number) {
  std::vector<Triangle> result = faces;
  for (Triangle& face : result) {
    for (Index& v : face) v = number[v];
  }
  return result;
}

// Stores each face's number in `face_groups`.
IndexedMesh numbered(IndexedMesh mesh) {
  mesh.face_groups.resize(mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) mesh.face_groups[f] = static_cast<Index>(f);
  return mesh;
}

// Few positions, many vertices at each, random faces: the worst case.
IndexedMesh random_coincident(std::uint64_t seed, std::size_t positions, Index vertices, std::size_t faces) {
  Random random(seed);
  std::vector<Vec3> sites;
  for (std::size_t i = 0; i < positions; ++i) sites.emplace_back(random.uniform(), random.uniform(), random.uniform());
  IndexedMesh mesh;
  for (Index v = 0; v < vertices; ++v) mesh.positions.push_back(sites[random.below(positions)]);
  while (mesh.faces.size() < faces) {
    Triangle face;
    for (Index& v : face) v = static_cast<Index>(random.below(vertices));
    if (has_three_corners(face)) mesh.faces.push_back(face);
  }
  drop_duplicate_faces(mesh);
  return numbered(mesh);
}

struct Kind {
  std::size_t positions;
  Index vertices;
  std::size_t faces;
};

// From soups to meshes in which most vertices are shared.
const std::vector<Kind> kinds = {{4, 12, 4},  {4, 30, 10},  {5, 36, 12}, {6, 24, 16}, {8, 20, 20},
                                 {8, 60, 20}, {10, 14, 18}, {6, 90, 30}, {20, 60, 40}};

template <class Check>
void for_random_meshes(const Check& check) {
  for (const Kind& kind : kinds) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const IndexedMesh before = random_coincident(seed, kind.positions, kind.vertices, kind.faces);
      IndexedMesh after = before;
      std::vector<Index> joined_to;
      const Repairs repairs = weld_borders(after, &joined_to);
      if (joined_to.empty()) {
        joined_to.resize(before.positions.size());
        for (std::size_t v = 0; v < joined_to.size(); ++v) joined_to[v] = static_cast<Index>(v);
      }
      check(before, after, joined_to, repairs,
            "seed " + std::to_string(seed) + ", " + std::to_string(kind.positions) + " positions, " +
                std::to_string(kind.vertices) + " vertices, " + std::to_string(kind.faces) + " faces");
      if (testing::Test::HasFailure()) return;
    }
  }
}

std::vector<std::size_t> originals(const IndexedMesh& after) {
  return std::vector<std::size_t>(after.face_groups.begin(), after.face_groups.end());
}

TEST(WeldBorders, JoinsOnlyCandidatesAtTheSamePositionToTheLowest) {
  for_random_meshes([](const IndexedMesh& before, const IndexedMesh& after, const std::vector<Index>& joined_to,
                       const Repairs& repairs, const std::string& what) {
    const std::vector<char> is_candidate = candidates(before);
    std::size_t welded = 0;
    for (std::size_t v = 0; v < joined_to.size(); ++v) {
      const Index to = joined_to[v];
      if (to == v) continue;
      ++welded;
      EXPECT_LT(to, v) << what;
      EXPECT_EQ(joined_to[to], to) << what;
      EXPECT_TRUE(is_candidate[v] && is_candidate[to]) << what;
      EXPECT_EQ(before.positions[v], before.positions[to]) << what;
    }
    EXPECT_EQ(repairs.welded_vertices, welded) << what;
    EXPECT_EQ(after.faces.size() + repairs.degenerate_faces + repairs.duplicate_faces, before.faces.size()) << what;
    for (std::size_t f = 0; f < after.faces.size(); ++f) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(after.faces[f][c], joined_to[before.faces[after.face_groups[f]][c]]) << what;
      }
    }
  });
}

TEST(WeldBorders, NeverGivesAnEdgeAThirdFace) {
  for_random_meshes([](const IndexedMesh& before, const IndexedMesh& after, const std::vector<Index>&, const Repairs&,
                       const std::string& what) {
    IndexedMesh clean = after;
    drop_duplicate_faces(clean);
    EXPECT_EQ(edges_gone_wrong(before, clean.faces, originals(clean)), 0U) << what;
  });
}

TEST(WeldBorders, JoinsEverythingWhereNoEdgeGetsAThirdFace) {
  std::size_t cases = 0;
  for_random_meshes([&](const IndexedMesh& before, const IndexedMesh&, const std::vector<Index>& joined_to,
                        const Repairs&, const std::string& what) {
    const std::vector<Index> all = weld_all(before);
    std::vector<std::size_t> identity(before.faces.size());
    for (std::size_t f = 0; f < identity.size(); ++f) identity[f] = f;
    if (edges_gone_wrong(before, renumbered(before.faces, all), identity) > 0) return;
    ++cases;
    EXPECT_EQ(joined_to, all) << what;
  });
  EXPECT_GT(cases, 100U);
}

// Whether welding these pairs of vertices would give an edge a third face.
bool would_be_wrong(const IndexedMesh& before, const IndexedMesh& after,
                    const std::vector<std::array<Index, 2>>& pairs) {
  std::vector<Index> number(before.positions.size());
  for (std::size_t v = 0; v < number.size(); ++v) number[v] = static_cast<Index>(v);
  for (const auto& [a, b] : pairs) number[std::max(a, b)] = std::min(a, b);
  return edges_gone_wrong(before, renumbered(after.faces, number), originals(after)) > 0;
}

bool has_edge_without_length(const IndexedMesh& mesh, const Triangle& t) {
  const auto at = [&](std::size_t c) { return mesh.positions[t[c % 3]]; };
  return at(0) == at(1) || at(1) == at(2) || at(2) == at(0);
}

TEST(WeldBorders, LeavesNoTwoOpenEdgesThatCouldBeOne) {
  std::size_t refused = 0;
  for_random_meshes([&](const IndexedMesh& before, const IndexedMesh& after, const std::vector<Index>&, const Repairs&,
                        const std::string& what) {
    const std::vector<char> is_candidate = candidates(before);
    std::vector<Edge> open;
    for (const auto& [edge, faces] : faces_by_edge(after.faces)) {
      if (faces.size() > 1 || !is_candidate[edge[0]] || !is_candidate[edge[1]]) continue;
      if (!has_edge_without_length(after, after.faces[faces[0]])) open.push_back(edge);
    }
    const auto at = [&](Index v) { return before.positions[v]; };
    for (std::size_t i = 0; i < open.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        auto [a, b] = open[i];
        const auto [c, d] = open[j];
        if (at(a) != at(c)) std::swap(a, b);
        if (at(a) != at(c) || at(b) != at(d) || at(a) == at(b)) continue;
        EXPECT_TRUE(would_be_wrong(before, after, {{a, c}, {b, d}}))
            << what << ": edges " << a << '-' << b << " and " << c << '-' << d;
        ++refused;
      }
    }
  });
  EXPECT_GT(refused, 100U);
}

TEST(WeldBorders, LeavesNoEdgeWithoutLengthThatCouldBeClosed) {
  std::size_t refused = 0;
  for_random_meshes([&](const IndexedMesh& before, const IndexedMesh& after, const std::vector<Index>&, const Repairs&,
                        const std::string& what) {
    for (const Triangle& face : after.faces) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [a, b] = edge_of(face, c);
        if (a == b || before.positions[a] != before.positions[b]) continue;
        EXPECT_TRUE(would_be_wrong(before, after, {{a, b}})) << what << ": edge " << a << '-' << b;
        ++refused;
      }
    }
  });
  EXPECT_GT(refused, 20U);
}

TEST(WeldBorders, MakesSoupsTheSurfacesTheyCameFrom) {
  std::vector<NamedMesh> meshes = whittle::test::closed_meshes();
  for (NamedMesh& open : whittle::test::open_meshes()) meshes.push_back(std::move(open));
  for (const auto& [name, mesh] : meshes) {
    IndexedMesh welded = soup(mesh);
    repair(welded);
    IndexedMesh expected = mesh;
    if (name.starts_with("soup")) expected = whittle::test::glued(mesh);
    EXPECT_EQ(topology(welded), topology(expected)) << name;
  }
}

TEST(WeldBorders, GivesTheSameSurfaceForSoupsInAnyOrder) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    IndexedMesh mesh = whittle::test::torus(8, 6);
    Random random(seed);
    for (std::size_t f = mesh.faces.size(); f > 1; --f) std::swap(mesh.faces[f - 1], mesh.faces[random.below(f)]);
    for (Triangle& face : mesh.faces) std::rotate(face.begin(), face.begin() + random.below(3), face.end());
    IndexedMesh welded = soup(mesh);
    repair(welded);
    EXPECT_EQ(topology(welded), topology(mesh)) << "seed " << seed;
  }
}

TEST(WeldBorders, KeepsPartsApartThatTouchAlongAnEdge) {
  for (const int pieces : {1, 3}) {
    IndexedMesh mesh = soup(whittle::test::two_cubes_on_an_edge(pieces));
    repair(mesh);
    const Topology t = topology(mesh);
    EXPECT_TRUE(t.closed() && t.manifold()) << t;
    EXPECT_EQ(t.components, 2) << t;
  }
}

TEST(WeldBorders, DecidesAlikeAllAlongALineWherePartsTouch) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    IndexedMesh mesh = whittle::test::two_cubes_on_an_edge(6);
    Random random(seed);
    for (std::size_t f = mesh.faces.size(); f > 1; --f) std::swap(mesh.faces[f - 1], mesh.faces[random.below(f)]);
    IndexedMesh welded = soup(mesh);
    repair(welded);
    const Topology t = topology(welded);
    EXPECT_TRUE(t.closed() && t.manifold()) << "seed " << seed << ": " << t;
    EXPECT_EQ(t.components, 2) << "seed " << seed << ": " << t;
  }
}

/// A cube of squares that are apart, each with a front and a back, becomes a cube and another one inside out.
TEST(WeldBorders, JoinsFrontsToFrontsAndBacksToBacks) {
  const IndexedMesh cube = whittle::test::cube();
  IndexedMesh inside_out = cube;
  for (Triangle& face : inside_out.faces) std::swap(face[1], face[2]);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    IndexedMesh mesh = whittle::test::joined(cube, inside_out);
    Random random(seed);
    for (std::size_t f = mesh.faces.size(); f > 1; --f) std::swap(mesh.faces[f - 1], mesh.faces[random.below(f)]);
    mesh = soup(mesh);
    repair(mesh);
    const Topology t = topology(mesh);
    EXPECT_TRUE(t.closed() && t.manifold()) << t;
    EXPECT_EQ(t.components, 2) << t;
    EXPECT_EQ(t.euler(), 4) << t;
    EXPECT_EQ(mesh.positions.size(), 16U);
  }
}

TEST(WeldBorders, JoinsPartsThatTouchAtAVertex) {
  IndexedMesh mesh = soup(whittle::test::bow_tie());
  repair(mesh);
  EXPECT_EQ(topology(mesh), topology(whittle::test::bow_tie()));
}

TEST(WeldBorders, JoinsTwoOfThreeFacesOnAnEdge) {
  IndexedMesh mesh = soup(whittle::test::three_faces_on_an_edge());
  repair(mesh);
  const Topology t = topology(mesh);
  EXPECT_EQ(t.nonmanifold_edges, 0) << t;
  EXPECT_EQ(t.components, 2) << t;
}

TEST(WeldBorders, LeavesInnerVerticesAtTheSamePositionApart) {
  IndexedMesh mesh = whittle::test::joined(whittle::test::tetrahedron(), whittle::test::tetrahedron());
  EXPECT_FALSE(repair(mesh).any());
  EXPECT_EQ(mesh.positions.size(), 8U);
}

TEST(WeldBorders, TakesNegativeZeroForZero) {
  IndexedMesh mesh;
  mesh.positions = {{0.0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-0.0, -0.0, 1}, {0, 1, -0.0}, {-1, 0, 0}};
  mesh.faces = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_EQ(weld_borders(mesh).welded_vertices, 2U);
}

TEST(WeldBorders, ClosesEdgesWithoutLengthInsideASurface) {
  // An octahedron. Its top is cut into two vertices at the same position, with two faces without area between them.
  IndexedMesh mesh = whittle::test::octahedron();
  const Vec3 top = mesh.positions[mesh.faces[0][0]];
  Index apex = mesh.faces[0][0];
  std::vector<std::size_t> around;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (std::count(mesh.faces[f].begin(), mesh.faces[f].end(), apex) > 0) around.push_back(f);
  }
  ASSERT_EQ(around.size(), 4U);
  // Two neighbouring faces around the apex go to the new vertex.
  const auto shared_corners = [&](std::size_t f, std::size_t g) {
    std::vector<Index> shared;
    for (const Index v : mesh.faces[f]) {
      if (v != apex && std::count(mesh.faces[g].begin(), mesh.faces[g].end(), v) > 0) shared.push_back(v);
    }
    return shared;
  };
  std::size_t partner = 1;
  while (shared_corners(around[0], around[partner]).empty()) ++partner;
  const auto twin = static_cast<Index>(mesh.positions.size());
  mesh.positions.push_back(top);
  std::vector<Index> ends;  // Of the slit, next to the apex.
  for (const std::size_t moved : {around[0], around[partner]}) {
    for (const std::size_t other : around) {
      if (other == around[0] || other == around[partner]) continue;
      for (const Index v : shared_corners(moved, other)) ends.push_back(v);
    }
  }
  ASSERT_EQ(ends.size(), 2U);
  for (const std::size_t f : {around[0], around[partner]}) {
    for (Index& v : mesh.faces[f]) v = v == apex ? twin : v;
  }
  mesh.faces.push_back({apex, twin, ends[0]});
  mesh.faces.push_back({twin, apex, ends[1]});
  ASSERT_TRUE(topology(mesh).closed() && topology(mesh).manifold()) << topology(mesh);

  const Repairs repairs = repair(mesh);
  EXPECT_EQ(repairs.welded_vertices, 1U);
  EXPECT_EQ(repairs.degenerate_faces, 2U);
  EXPECT_EQ(topology(mesh), topology(whittle::test::octahedron()));
}

TEST(WeldBorders, KeepsASurfaceClosedWhereAnEdgeWithoutLengthMustStay) {
  // Two pyramids base to base, without the base 0 1 2. Closing the edge 0–1 would give the edge to vertex 2 four faces.
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.faces = {{3, 0, 1}, {3, 1, 2}, {3, 2, 0}, {4, 1, 0}, {4, 2, 1}, {4, 0, 2}};
  const std::vector<Triangle> before = mesh.faces;
  EXPECT_FALSE(repair(mesh).any());
  EXPECT_EQ(mesh.faces, before);
}

TEST(WeldBorders, KeepsTheOriginOfTheLowestVertex) {
  IndexedMesh mesh = soup(whittle::test::two_triangles());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.origins.push_back(static_cast<Index>(10 * v));
  repair(mesh);
  ASSERT_EQ(mesh.positions.size(), 4U);
  for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(mesh.origins[v], 10 * v);
}

TEST(WeldBorders, DropsFacesThatLieTwiceAtADoubtfulEdge) {
  // A soup of two cubes that touch along an edge, with each face twice.
  IndexedMesh mesh = soup(whittle::test::two_cubes_on_an_edge());
  const auto twice = static_cast<Index>(mesh.positions.size());
  const IndexedMesh once = mesh;
  mesh.positions.insert(mesh.positions.end(), once.positions.begin(), once.positions.end());
  for (const Triangle& t : once.faces) mesh.faces.push_back({t[1] + twice, t[2] + twice, t[0] + twice});
  const Repairs repairs = repair(mesh);
  EXPECT_EQ(repairs.duplicate_faces, once.faces.size());
  EXPECT_TRUE(topology(mesh).closed() && topology(mesh).manifold()) << topology(mesh);
}

TEST(Repair, DropsCopiesOfASheetWithVerticesOfTheirOwn) {
  const IndexedMesh sheet = whittle::test::noisy_grid(6, 5, 0.2, 1);
  IndexedMesh mesh = sheet;
  for (const std::size_t n_copies : {1U, 2U}) {
    mesh = whittle::test::joined(mesh, sheet);
    IndexedMesh repaired = mesh;
    const Repairs repairs = repair(repaired);
    EXPECT_EQ(repairs.duplicate_faces, n_copies * sheet.faces.size());
    EXPECT_EQ(repairs.welded_vertices, 0U);
    EXPECT_EQ(repaired.faces, sheet.faces);
    EXPECT_EQ(repaired.positions, sheet.positions);
  }
}

TEST(Repair, KeepsASheetAndItsBackSide) {
  const IndexedMesh sheet = whittle::test::noisy_grid(6, 5, 0.2, 1);
  IndexedMesh mesh = whittle::test::joined(sheet, whittle::test::inside_out(sheet));
  EXPECT_EQ(repair(mesh).duplicate_faces, 0U);
  EXPECT_EQ(mesh.faces.size(), 2 * sheet.faces.size());
  EXPECT_EQ(topology(mesh).misoriented_edges, 0);
}

TEST(WeldBorders, EndsSoonWhereThousandsOfFacesMeetInAnEdge) {
  IndexedMesh mesh;
  for (Index f = 0; f < 20000; ++f) {
    mesh.positions.insert(mesh.positions.end(), {{0, 0, 0}, {0, 0, 1}, {1, static_cast<double>(f), 0}});
    mesh.faces.push_back({3 * f, 3 * f + 1, 3 * f + 2});
  }
  EXPECT_EQ(weld_borders(mesh).welded_vertices, 0U);
}

}  // namespace
}  // namespace whittle::io
