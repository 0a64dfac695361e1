// Compares the mesh driver with brute force on every small manifold shape: the same contractions, to the bit, including
// ties and flat ground. Both evaluate the same pairs from the same numbers.
#include <gtest/gtest.h>

#include <whittle/core/feature_edges.hh>

#include "common/meshes.hh"
#include "common/modules.hh"
#include "oracle/brute_force.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

const DecimateTarget as_far_as_possible = DecimateTarget::as_far_as_possible();

std::vector<Contraction> by_mesh_driver(const IndexedMesh& shape, const DecimateTarget& target,
                                        const DecimateOptions& options) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  PairDecimaterT<DoubleMesh> decimater(mesh);
  add_cost(decimater, {options.effective_cost(), options.quadric, options.isotropy, options.valence_weight});
  add_module<ModFlipGuardT<DoubleMesh>>(decimater).set_max_normal_flip_deg(options.effective_max_normal_flip_deg());
  add_module<ModRadiusRatioT<DoubleMesh>>(decimater).set_min_radius_ratio(options.min_radius_ratio.value_or(0));
  mark_edges(mesh, {options.feature_edges.begin(), options.feature_edges.end()});
  decimater.set_feature_tolerance(options.feature_tolerance);
  for (const OpenMesh::VertexHandle v : mesh.vertices()) {
    const auto number = static_cast<std::size_t>(v.idx());
    mesh.status(v).set_locked(!options.locked.empty() && options.locked[number] != 0);
  }
  std::vector<Contraction> contractions;
  decimater.set_listener([&](const Contraction& made) { contractions.push_back(made); });
  decimater.set_driver(Driver::mesh);
  EXPECT_TRUE(decimater.initialize());
  const DecimateResult result = decimater.decimate(target);
  EXPECT_EQ(result.n_contractions, contractions.size());
  expect_sound(mesh, "after the run");
  const IndexedMesh after = geometry_of(mesh);
  EXPECT_EQ(result.n_faces, after.faces.size());
  expect_same_topology(shape, after, "after the run");
  return contractions;
}

TEST(PairDecimaterOracle, EveryShapeIsContractedAsByBruteForce) {
  for (const auto& [name, shape] : holdable_meshes()) {
    expect_same_contractions(BruteForceDecimater(shape, {}).run(as_far_as_possible),
                             by_mesh_driver(shape, as_far_as_possible, {}), name);
  }
}

TEST(PairDecimaterOracle, SoItIsUnderAllWeightsAndPlacements) {
  for (const Weights weights : {Weights::area, Weights::uniform, Weights::area_angle}) {
    for (const Placement placement : {Placement::optimal, Placement::midpoint, Placement::endpoint}) {
      for (const double regularization : {0.0, 1e-6}) {
        DecimateOptions options;
        options.quadric = {.weights = weights, .placement = placement, .regularization = regularization};
        options.max_normal_flip_deg = 110;
        for (const auto& shape : {noisy_sphere(2, 0.1, 3), noisy_grid(7, 7, 0.3, 4), frustum(9)}) {
          const std::string context = "weights " + std::to_string(static_cast<int>(weights)) + ", placement " +
                                      std::to_string(static_cast<int>(placement)) + ", regularization " +
                                      std::to_string(regularization) + ", " + std::to_string(shape.faces.size()) +
                                      " faces";
          expect_same_contractions(BruteForceDecimater(shape, options).run(as_far_as_possible),
                                   by_mesh_driver(shape, as_far_as_possible, options), context);
        }
      }
    }
  }
}

TEST(PairDecimaterOracle, SoItIsWithLockedVerticesAndFreeBorders) {
  for (const auto& [name, shape] : holdable_meshes()) {
    std::vector<std::uint8_t> locked(shape.positions.size());
    for (std::size_t v = 0; v < locked.size(); ++v) locked[v] = v % 7 == 2 || v % 11 < 2;
    DecimateOptions options;
    options.quadric.boundary_weight = 0;
    options.locked = locked;
    expect_same_contractions(BruteForceDecimater(shape, options).run(as_far_as_possible),
                             by_mesh_driver(shape, as_far_as_possible, options), name);
  }
}

TEST(PairDecimaterOracle, SoItIsUnderEveryCost) {
  for (const NamedCost& cost : named_costs()) {
    DecimateOptions options;
    options.cost = cost.options.cost;
    options.isotropy = cost.options.isotropy;
    options.valence_weight = cost.options.valence_weight;
    options.min_radius_ratio = 0.2;
    for (const auto& shape : {noisy_sphere(2, 0.1, 3), noisy_grid(7, 7, 0.3, 4), frustum(9), bracket(2)}) {
      expect_same_contractions(BruteForceDecimater(shape, options).run(as_far_as_possible),
                               by_mesh_driver(shape, as_far_as_possible, options),
                               cost.name + ", " + std::to_string(shape.faces.size()) + " faces");
    }
  }
}

TEST(PairDecimaterOracle, SoItIsWithFeatureEdges) {
  for (const double tolerance : {5e-4, 0.05, 1.0}) {
    for (const Cost cost : {Cost::quadric, Cost::memoryless, Cost::lindstrom_turk}) {
      for (const auto& shape : {open_cylinder(16, 5), frustum(9), bracket(2), noisy_grid(7, 7, 0.6, 4)}) {
        const std::vector<VertexPair> features = feature_edges(shape, 30);
        std::vector<std::uint8_t> locked(shape.positions.size());
        for (std::size_t v = 0; v < locked.size(); ++v) locked[v] = v % 9 == 4;
        DecimateOptions options;
        options.cost = cost;
        options.feature_edges = features;
        options.feature_tolerance = tolerance;
        options.locked = locked;
        expect_same_contractions(
            BruteForceDecimater(shape, options).run(as_far_as_possible),
            by_mesh_driver(shape, as_far_as_possible, options),
            "tolerance " + std::to_string(tolerance) + ", " + std::to_string(shape.faces.size()) + " faces");
      }
    }
  }
}

TEST(PairDecimaterOracle, TargetsStopAtTheSameContraction) {
  const IndexedMesh shape = moved(scaled(blob(2, 9), 1000), Vec3(3e4, -1e5, 2e5));
  const double middle_cost = BruteForceDecimater(shape, {}).run(to_faces(160)).back().cost;
  const DecimateTarget all = to_faces(200).or_vertices(50).or_max_cost(middle_cost / 2);
  for (const DecimateTarget& target : {to_faces(101), to_vertices(77), to_cost(middle_cost), all}) {
    expect_same_contractions(BruteForceDecimater(shape, {}).run(target), by_mesh_driver(shape, target, {}),
                             "faces " + std::to_string(target.n_faces().value_or(0)));
  }
}

}  // namespace
}  // namespace whittle::test
