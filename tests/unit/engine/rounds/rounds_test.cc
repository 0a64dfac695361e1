// Contraction in rounds: each round against the definition, and what a round keeps.
#include "rounds/rounds.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "unit/engine/rounds/in_rounds.hh"
#include "unit/engine/rounds/naive_round.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::test {
namespace {

IndexedMesh flattened(IndexedMesh mesh, double factor) {
  for (Vec3& p : mesh.positions) p.z() *= factor;
  return mesh;
}

/// With a triangle on the first edge of every n-th face.
IndexedMesh with_flaps(IndexedMesh mesh, std::size_t n) {
  const std::size_t n_faces = mesh.faces.size();
  for (std::size_t f = 0; f < n_faces; f += n) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 normal = area_normal(mesh.positions, mesh.faces[f]).normalized();
    mesh.positions.push_back(mesh.positions[a] + 0.1 * normal);
    mesh.faces.push_back({a, b, static_cast<Index>(mesh.positions.size() - 1)});
  }
  return mesh;
}

/// The ends of edges that have not exactly two faces, ascending.
std::vector<Index> ends_of_irregular_edges(const IndexedMesh& mesh) {
  std::map<std::set<Index>, int> n_faces;
  for (const Triangle& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++n_faces[{face[k], face[(k + 1) % 3]}];
  }
  std::set<Index> ends;
  for (const auto& [edge, n] : n_faces) {
    if (n != 2) ends.insert(edge.begin(), edge.end());
  }
  return {ends.begin(), ends.end()};
}

/// The limit of a round that takes some pairs, and leaves others.
RoundLimit limit_of(const Rounds& rounds, std::uint64_t n_pairs, double slack) {
  const CostCounts* const counts = &rounds.cost_counts();
  return limits_of_parts({&counts, 1}, {n_pairs, slack}).front();
}

SurfaceAttributes attributes_of(const IndexedMesh& mesh) {
  if (!looks_at_attributes(options_of_rounds(), mesh)) return {};
  return InputAttributes(mesh, Frame{}, scaled_attributes(mesh, Frame{}, {}, 1)).all(1);
}

IndexedMesh colored(IndexedMesh mesh) {
  for (const Vec3& p : mesh.positions) {
    const auto wave = [&](double x) { return static_cast<float>(0.5 + 0.5 * std::sin(5 * x)); };
    mesh.colors.push_back({wave(p.x()), wave(p.y()), wave(p.z()), 1});
  }
  return mesh;
}

IndexedMesh noisy_texture(IndexedMesh mesh) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-0.02, 0.02);
  for (double& number : mesh.attributes.front().values) number += noise(random);
  return mesh;
}

/// Six rounds. \return faces left
std::size_t expect_rounds_by_definition(const IndexedMesh& mesh, const DecimateOptions& options, double slack) {
  IndexedMesh before = mesh;
  SurfaceAttributes attributes = attributes_of(mesh);
  BruteForceAttributes expected_attributes(mesh, Frame{}, options);
  for (int round = 0; round < 6; ++round) {
    InRounds in_rounds(before, {}, {}, attributes, options);
    in_rounds.rounds().begin_round();
    const RoundLimit limit = limit_of(in_rounds.rounds(), before.positions.size() / 4, slack);
    in_rounds.rounds().contract(limit);
    const std::vector<NaiveContraction> expected =
        naive_round(before, options, mean_area(before), limit, expected_attributes);
    EXPECT_EQ(in_rounds.made().size(), expected.size());
    for (std::size_t i = 0; i < std::min(expected.size(), in_rounds.made().size()); ++i) {
      const Contraction& made = in_rounds.made()[i];
      EXPECT_EQ(made.survivor, expected[i].survivor) << "contraction " << i;
      EXPECT_EQ(made.removed, expected[i].removed) << "contraction " << i;
      EXPECT_LT((made.position - expected[i].position).norm(), 1e-9) << "contraction " << i;
      if (::testing::Test::HasFailure()) return before.faces.size();
    }
    before = in_rounds.result();
    attributes = in_rounds.attributes();
  }
  return before.faces.size();
}

TEST(Rounds, ContractWhatTheDefinitionSays) {
  for (const auto& [name, mesh] :
       {NamedMesh{"textured_torus", noisy_texture(textured_torus(24, 12))},
        NamedMesh{"tiled_torus", noisy_texture(tiled_torus(24, 12, 6))}, NamedMesh{"colored", colored(blob(3, 2))},
        NamedMesh{"blob", blob(3, 7)}, NamedMesh{"noisy_sphere", noisy_sphere(3, 0.1, 3)},
        NamedMesh{"noisy_torus", noisy_torus(24, 10, 1, 0.35, 0.05, 2)}, NamedMesh{"knot", knot(80, 6)},
        NamedMesh{"icosahedron", icosahedron()}, NamedMesh{"csaszar_torus", csaszar_torus()},
        NamedMesh{"needles", flattened(noisy_sphere(3, 0.1, 5), 0.01)}}) {
    for (const double slack : {1.0, 3.0, 1e9}) {
      SCOPED_TRACE(name + ", slack " + std::to_string(slack));
      const std::size_t n_faces = expect_rounds_by_definition(mesh, options_of_rounds(), slack);
      const bool needs_all_edges = name == "csaszar_torus";
      EXPECT_EQ(n_faces < mesh.faces.size(), !needs_all_edges);
    }
  }
}

TEST(Rounds, ContractWhatPlacementAndValencesAskFor) {
  for (const auto& [name, mesh] :
       {NamedMesh{"blob", blob(3, 7)}, NamedMesh{"noisy_torus", noisy_torus(24, 10, 1, 0.35, 0.05, 2)},
        NamedMesh{"knot", knot(80, 6)}, NamedMesh{"colored", colored(blob(3, 2))},
        NamedMesh{"tiled_torus", noisy_texture(tiled_torus(24, 12, 6))}}) {
    for (const Placement placement : {Placement::optimal, Placement::midpoint, Placement::endpoint}) {
      for (const double weight : {0.0, 0.5, 5.0}) {
        SCOPED_TRACE(name + ", placement " + std::to_string(static_cast<int>(placement)) + ", valence " +
                     std::to_string(weight));
        DecimateOptions options = options_of_rounds();
        options.quadric.placement = placement;
        options.valence_weight = weight;
        EXPECT_LT(expect_rounds_by_definition(mesh, options, 3), mesh.faces.size());
      }
    }
  }
}

TEST(Rounds, KeepTopologyAndOrientation) {
  for (const auto& [name, mesh] : all_meshes()) {
    SCOPED_TRACE(name);
    const Topology before = topology(mesh);
    if (!before.manifold()) continue;
    InRounds in_rounds(mesh);
    in_rounds.rounds().start(DecimateTarget::faces(mesh.faces.size() / 8));
    in_rounds.rounds().run(1e30);
    const IndexedMesh result = in_rounds.result();
    const Topology after = topology(result);
    EXPECT_TRUE(after.manifold());
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.euler(), before.euler());
    EXPECT_EQ(after.border_loops, before.border_loops);
    EXPECT_LE(after.misoriented_edges, before.misoriented_edges);
    EXPECT_EQ(result.faces.size(), in_rounds.rounds().n_faces());
    EXPECT_EQ(in_rounds.rounds().n_contractions(), in_rounds.made().size());
  }
}

TEST(Rounds, LeaveFrozenVertices) {
  for (const auto& [name, mesh] : nonmanifold_meshes()) {
    SCOPED_TRACE(name);
    std::vector<std::uint8_t> frozen(mesh.positions.size());
    for (Index v = 0; v < frozen.size(); v += 3) frozen[v] = 1;
    InRounds in_rounds(mesh, frozen);
    in_rounds.rounds().run(1e30);
    for (const Contraction& made : in_rounds.made()) {
      EXPECT_EQ(frozen[made.survivor] + frozen[made.removed], 0);
    }
    EXPECT_EQ(topology(in_rounds.result()).euler(), topology(mesh).euler());
  }
}

TEST(Rounds, KeepTheTopologyOfWhatIsNotManifold) {
  std::size_t n_at_irregular = 0;
  std::vector<NamedMesh> meshes = nonmanifold_meshes();
  meshes.push_back({"flaps", with_flaps(blob(3, 4), 20)});
  meshes.push_back({"book", book(5, 20)});
  for (const auto& [name, mesh] : meshes) {
    SCOPED_TRACE(name);
    const Topology before = topology(mesh);
    InRounds in_rounds(mesh);
    while (in_rounds.rounds().n_faces() > 1) {
      const std::uint64_t n_before = in_rounds.rounds().n_contractions();
      in_rounds.rounds().begin_round();
      in_rounds.rounds().contract({CostCounts::highest, 1 + mesh.positions.size() / 8});
      if (in_rounds.rounds().n_contractions() == n_before) break;
      const Topology after = topology(in_rounds.result());
      ASSERT_EQ(after.components, before.components);
      ASSERT_EQ(after.euler(), before.euler());
      ASSERT_LE(after.nonmanifold_edges, before.nonmanifold_edges);
      ASSERT_LE(after.misoriented_edges, before.misoriented_edges);
    }
    const std::vector<Index> irregular = ends_of_irregular_edges(mesh);
    for (const Contraction& made : in_rounds.made()) {
      n_at_irregular += static_cast<std::size_t>(std::binary_search(irregular.begin(), irregular.end(), made.removed));
    }
  }
  EXPECT_GT(n_at_irregular, 50U);
}

TEST(Rounds, LeaveLockedVerticesWhereTheyAre) {
  for (const IndexedMesh& mesh : {noisy_sphere(4, 0.1, 2), terrain(24, 2)}) {
    std::vector<std::uint8_t> locked(mesh.positions.size());
    for (Index v = 0; v < locked.size(); v += 5) locked[v] = 1;
    InRounds in_rounds(mesh, {}, locked);
    in_rounds.rounds().run(1e30);
    EXPECT_GT(in_rounds.made().size(), mesh.positions.size() / 2);
    std::size_t n_next_to_locked = 0;
    for (const Contraction& made : in_rounds.made()) {
      EXPECT_EQ(locked[made.removed], 0);
      if (locked[made.survivor] == 0) continue;
      ++n_next_to_locked;
      EXPECT_EQ(made.position, mesh.positions[made.survivor]);
    }
    EXPECT_GT(n_next_to_locked, 0U);
  }
}

TEST(Rounds, KeepBordersWhereTheyAre) {
  IndexedMesh mesh = noisy_grid(24, 24, 0.02, 4);
  InRounds in_rounds(mesh);
  in_rounds.rounds().start(DecimateTarget::faces(mesh.faces.size() / 20));
  in_rounds.rounds().run(1e30);
  const IndexedMesh result = in_rounds.result();
  std::vector<Vec3> used;
  for (const Triangle& face : result.faces) {
    for (const Index v : face) used.push_back(result.positions[v]);
  }
  const Vec3 size = bounds_of(mesh.positions).sizes();
  const Vec3 size_left = bounds_of(used).sizes();
  EXPECT_NEAR(size_left.x(), size.x(), 0.02 * size.x());
  EXPECT_NEAR(size_left.maxCoeff(), size.maxCoeff(), 0.02 * size.maxCoeff());
}

TEST(Rounds, EndWhereNothingIsLeftToContract) {
  for (const IndexedMesh& mesh : {tetrahedron(), octahedron(), csaszar_torus(), single_triangle(), spheres(4, 1)}) {
    InRounds in_rounds(mesh);
    std::uint64_t n_turns = 1;
    for (int round = 0; n_turns > 0; ++round) {
      ASSERT_LT(round, 1000);
      in_rounds.rounds().begin_round();
      n_turns = in_rounds.rounds().contract({CostCounts::highest, mesh.positions.size()});
    }
    EXPECT_EQ(topology(in_rounds.result()).euler(), topology(mesh).euler());
  }
}

// The parts of a round ----------------------------------------------------------------------------------------------

TEST(RoundLimits, ShareThePairsThatCostLeast) {
  const std::vector<std::vector<float>> costs{{1, 2, 3, 9}, {1, 1, 8, CostCounts::never}, {}, {3, 3}};
  std::vector<CostCounts> counts(costs.size());
  std::vector<const CostCounts*> parts;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    counts[i].count(costs[i]);
    parts.push_back(&counts[i]);
  }
  for (std::uint64_t n = 0; n < 12; ++n) {
    const std::vector<RoundLimit> limits = limits_of_parts(parts, {n, 1});
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < costs.size(); ++i) {
      EXPECT_LE(limits[i].n_pairs, costs[i].size());
      EXPECT_EQ(limits[i].cost, limits[0].cost);
      sum += limits[i].n_pairs;
    }
    EXPECT_EQ(sum, std::min<std::uint64_t>(n, 10));
  }
  const std::vector<RoundLimit> of_six = limits_of_parts(parts, {6, 1});
  EXPECT_EQ(of_six[0].n_pairs, 3U);  // 1 and 2, and the first of those that cost 3
  EXPECT_EQ(of_six[1].n_pairs, 2U);
  EXPECT_EQ(of_six[3].n_pairs, 1U);
  EXPECT_GE(of_six[0].cost, 3.0F);
  EXPECT_LT(of_six[0].cost, 8.0F);
  EXPECT_GE(limits_of_parts(parts, {6, 3})[0].cost, 9.0F);
}

TEST(CostClasses, AreInOrder) {
  std::uint32_t before = 0;
  for (const double cost : {-1.0, 0.0, 1e-300, 1e-30, 1.0, 1.02, 2.0, 1e29, 1e30, 1e300}) {
    const std::uint32_t now = CostCounts::class_of(CostCounts::in_range(cost));
    EXPECT_GE(now, before) << cost;
    EXPECT_LT(now, CostCounts::n_classes);
    before = now;
  }
  EXPECT_EQ(CostCounts::in_range(std::numeric_limits<double>::quiet_NaN()), CostCounts::highest);
  EXPECT_LT(CostCounts::class_of(CostCounts::highest), CostCounts::class_of(CostCounts::never));
}

TEST(HeldPairs, WaitUntilTheirFacesChange) {
  HeldPairs held(6);
  held.add_refused({0, 1}, 3);
  held.add_dear({2, 3}, 5, 3);
  held.add_dear({4, 5}, 5, 3);
  held.note_change(1, 2);  // before
  held.note_change(3, 4);
  held.begin_round();
  EXPECT_EQ(held.cost({0, 1}, 1), CostCounts::never);
  EXPECT_EQ(held.cost({2, 3}, 1), 1.0F);
  EXPECT_EQ(held.cost({4, 5}, 1), 5.0F);
  EXPECT_EQ(held.cost({4, 5}, 7), 7.0F);
  EXPECT_EQ(held.cost({0, 5}, 1), 1.0F);
  const std::vector<VertexPair> pairs{{0, 5}, {0, 1}, {2, 3}, {4, 5}};
  std::vector<float> costs(pairs.size(), 1);
  held.raise(pairs, costs);
  for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_EQ(costs[i], held.cost(pairs[i], 1));
  costs.assign(2, 7);
  held.raise(std::span(pairs).subspan(2), costs);
  EXPECT_EQ(costs, (std::vector<float>{7, 7}));
  held.note_change(0, 5);
  held.begin_round();
  EXPECT_EQ(held.cost({0, 1}, 1), 1.0F);
}

TEST(StarPlanes, AreThoseOfTheFaces) {
  const IndexedMesh mesh = noisy_sphere(2, 0.2, 9);
  std::vector<LanePoint> points;
  for (const Vec3& p : mesh.positions) points.emplace_back(p);
  for (const std::size_t n : {std::size_t{0}, std::size_t{1}, std::size_t{7}, mesh.faces.size()}) {
    for (Index v = 0; v < points.size(); ++v) {
      SymmetricMatrix sum;
      Vec3 normal = Vec3::Zero();
      double length = 0;
      std::vector<LinkEdge> star;
      for (std::size_t f = 0; f < n; ++f) {
        Triangle face = mesh.faces[f];
        const auto at = std::find(face.begin(), face.end(), v);
        if (at == face.end()) continue;
        std::rotate(face.begin(), at, face.end());
        const auto& [a, b, c] = face;
        sum += corner_quadric(mesh.positions[a], mesh.positions[b], mesh.positions[c], {});
        const Vec3 n_face = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
        normal += n_face;
        length += n_face.norm();
        star.push_back({b, c});
      }
      const StarPlanes planes = planes_of_star(v, star, points, {});
      EXPECT_NEAR(planes.matrix().xx, sum.xx, 1e-12);
      EXPECT_NEAR(planes.matrix().xz, sum.xz, 1e-12);
      EXPECT_NEAR(planes.matrix().zz, sum.zz, 1e-12);
      EXPECT_LT((planes.normal() - normal).norm(), 1e-12);
      EXPECT_NEAR(planes.length(), length, 1e-12);
    }
  }
}

TEST(PairCosts, AreTheSameAmongOthersAsAlone) {
  for (const IndexedMesh& mesh :
       {noisy_sphere(3, 0.1, 4), tessellated_cube(6), flattened(blob(3, 2), 1e-6), colored(blob(3, 3)),
        colored(flattened(blob(3, 2), 0)), noisy_texture(tiled_torus(24, 12, 6))}) {
    std::vector<LanePoint> points;
    for (const Vec3& p : mesh.positions) points.emplace_back(p);
    RoundScratch scratch;
    const RoundMesh in_rounds(mesh.positions, mesh.faces, {}, false, scratch);
    std::vector<StarPlanes> stars;
    for (Index v = 0; v < points.size(); ++v) {
      stars.push_back(planes_of_star(v, in_rounds.star(v), points, {}));
    }
    std::vector<VertexPair> pairs;
    for (const Triangle& face : mesh.faces) pairs.push_back({std::min(face[0], face[1]), std::max(face[0], face[1])});
    pairs.pop_back();  // no multiple of the lanes
    std::vector<float> ranks(pairs.size());
    const AttributeQuadrics attributes(attributes_of(mesh), points.size());
    for (const Placement placement : {Placement::optimal, Placement::midpoint, Placement::endpoint}) {
      const PairCosts costs(points, stars, mean_area(mesh).first(), placement);
      costs.rank(pairs, ranks);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_EQ(ranks[i], CostCounts::in_range(costs.of(pairs[i]).cost));
      }
      if (!attributes.any()) continue;
      costs.rank(pairs, attributes, ranks);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_EQ(ranks[i], CostCounts::in_range(costs.of(pairs[i], attributes).cost));
      }
    }
  }
}

}  // namespace
}  // namespace whittle::test
