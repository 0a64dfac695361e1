#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"

// Results must not depend on these, for any cost and any placement.

namespace whittle::test {
namespace {

struct CostSetting {
  std::string name;
  double dimension;  ///< the unit of the cost is a length to this power
  DecimateOptions options;

  /// In an approximate order some contractions depend on which costs share a bucket. That changes in all units except
  /// those that differ by powers of two. They also depend on which of two merged edges lives on; the vertices' numbers
  /// decide that.
  bool has_exact_order() const { return options.effective_order() == Order::exact; }
};

void PrintTo(const CostSetting& setting, std::ostream* out) { *out << setting.name; }

std::vector<CostSetting> all_cost_settings() {
  std::vector<CostSetting> settings;
  const auto add = [&](const std::string& name, double dimension, auto change) {
    settings.push_back({name, dimension, {}});
    change(settings.back().options);
  };
  for (const CostTraits& traits : all_cost_traits) {
    add(std::string(traits.name), traits.dimension, [&traits](DecimateOptions& o) { o.cost = traits.cost; });
  }
  add("memoryless, exact", 5, [](DecimateOptions& o) {
    o.cost = Cost::memoryless;
    o.order = Order::exact;
  });
  add("valence 1, memoryless", 5, [](DecimateOptions& o) {
    o.valence_weight = 1;
    o.cost = Cost::memoryless;
  });
  add("features 15, memoryless", 5, [](DecimateOptions& o) {
    o.feature_angle_deg = 15;
    o.cost = Cost::memoryless;
  });
  add("isotropic 0.3", 3.4, [](DecimateOptions& o) { o.isotropy = 0.3; });
  add("isotropic 0.3, uniform", 2, [](DecimateOptions& o) {
    o.isotropy = 0.3;
    o.quadric.weights = Weights::uniform;
  });
  add("isotropic 1", 2, [](DecimateOptions& o) { o.isotropy = 1; });
  add("valence 0.5", 4, [](DecimateOptions& o) { o.valence_weight = 0.5; });
  add("valence 1, lindstrom-turk", 6, [](DecimateOptions& o) {
    o.valence_weight = 1;
    o.cost = Cost::lindstrom_turk;
  });
  add("radius ratio 0.4", 4, [](DecimateOptions& o) { o.min_radius_ratio = 0.4; });
  add("features 15", 4, [](DecimateOptions& o) { o.feature_angle_deg = 15; });
  add("features 15, lindstrom-turk", 6, [](DecimateOptions& o) {
    o.feature_angle_deg = 15;
    o.cost = Cost::lindstrom_turk;
  });
  return settings;
}

class CostInvariance : public testing::TestWithParam<CostSetting> {
 protected:
  static std::vector<Contraction> contractions(const IndexedMesh& mesh) {
    std::vector<Contraction> done;
    DecimateOptions options = GetParam().options;
    options.listener = [&](const Contraction& c) { done.push_back(c); };
    decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 10), options);
    return done;
  }
  /// \param unit length in `there` of what is 1 in `here`
  static void expect_same(const std::vector<Contraction>& here, const std::vector<Contraction>& there, double unit) {
    ASSERT_EQ(there.size(), here.size());
    const double cost_unit = std::pow(unit, GetParam().dimension);
    for (std::size_t i = 0; i < here.size(); ++i) {
      ASSERT_EQ(there[i].survivor, here[i].survivor) << i;
      ASSERT_EQ(there[i].removed, here[i].removed) << i;
      // Rounding at lengths of about 1 and at moved coordinates, grown over some hundred contractions.
      ASSERT_NEAR(there[i].cost / cost_unit, here[i].cost, 1e-6 * here[i].cost + 1e-13) << i;
    }
  }
};

/// Moves every vertex a little at random. On an even grid, opposite moves of a vertex may change the volume by the same
/// amount.
IndexedMesh shaken(IndexedMesh mesh, double amplitude) {
  Random random(14);
  for (Vec3& p : mesh.positions) p += random.uniform_vector(-amplitude, amplitude);
  return mesh;
}

/// Meshes without two costs that differ by rounding only.
std::vector<std::pair<std::string, IndexedMesh>> rough_meshes() {
  return {{"noisy_sphere", noisy_sphere(3, 0.03, 10)},
          {"noisy_grid", shaken(noisy_grid(20, 16, 0.3, 11), 0.1)},
          {"terrain", shaken(terrain(20, 12), 0.005)}};
}

TEST_P(CostInvariance, PowersOfTwoAsTheUnitChangeNoBit) {
  for (const auto& [name, mesh] : rough_meshes()) {
    const std::vector<Contraction> here = contractions(mesh);
    for (const double factor : {0x1p10, 0x1p-10, 0x1p100, 0x1p-100}) {
      SCOPED_TRACE(name + " × " + std::to_string(factor));
      const std::vector<Contraction> there = contractions(scaled(mesh, factor));
      ASSERT_EQ(there.size(), here.size());
      for (std::size_t i = 0; i < here.size(); ++i) {
        ASSERT_EQ(there[i].survivor, here[i].survivor) << i;
        ASSERT_EQ(there[i].removed, here[i].removed) << i;
        ASSERT_EQ(there[i].position, here[i].position * factor) << i;
      }
    }
  }
}

TEST_P(CostInvariance, OtherPlacesGiveTheSameContractions) {
  for (const auto& [name, mesh] : rough_meshes()) {
    SCOPED_TRACE(name);
    expect_same(contractions(mesh), contractions(moved(mesh, {30, -20, 50})), 1);
  }
}

TEST_P(CostInvariance, TurnsOfAClosedSurfaceGiveTheSameContractions) {
  const IndexedMesh mesh = noisy_sphere(3, 0.03, 10);
  const std::vector<Contraction> here = contractions(mesh);
  for (const std::uint64_t seed : {1U, 2U, 3U}) expect_same(here, contractions(rotated(mesh, seed)), 1);
}

TEST_P(CostInvariance, ThreadsChangeNoBit) {
  const IndexedMesh mesh = noisy_sphere(5, 0.01, 13);
  DecimateOptions options = GetParam().options;
  options.threads = 1;
  const DecimateTarget target = DecimateTarget::faces(10'000);
  const Decimation one = decimate(mesh, target, options);
  for (const unsigned threads : {2U, 3U, 8U}) {
    options.threads = threads;
    const Decimation many = decimate(mesh, target, options);
    EXPECT_EQ(many.mesh.positions, one.mesh.positions) << threads;
    EXPECT_EQ(many.mesh.faces, one.mesh.faces) << threads;
  }
}

class ExactCostInvariance : public CostInvariance {};

TEST_P(ExactCostInvariance, OtherUnitsGiveTheSameContractions) {
  for (const auto& [name, mesh] : rough_meshes()) {
    const std::vector<Contraction> here = contractions(mesh);
    for (const double unit : {1000.0, 0.001}) {
      SCOPED_TRACE(name + " × " + std::to_string(unit));
      expect_same(here, contractions(scaled(mesh, unit)), unit);
    }
  }
}

/// The survivors are different ones, because vertices with higher numbers survive.
TEST_P(ExactCostInvariance, AnotherOrderOfVerticesAndFacesGivesTheSameSurface) {
  for (const auto& [name, mesh] : rough_meshes()) {
    SCOPED_TRACE(name);
    const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 10);
    const Decimation here = decimate(mesh, target, GetParam().options);
    const Permuted other = permuted(mesh, 12);
    const Decimation there = decimate(other.mesh, target, GetParam().options);
    ASSERT_EQ(there.mesh.positions.size(), here.mesh.positions.size());
    EXPECT_EQ(there.feature_edges.size(), here.feature_edges.size());
    for (Index v = 0; v < other.old_vertex.size(); ++v) {
      const Vec3& p = there.mesh.positions[there.vertex_map[v]];
      const Vec3& q = here.mesh.positions[here.vertex_map[other.old_vertex[v]]];
      ASSERT_LE((p - q).norm(), 1e-6 * diagonal(mesh)) << "vertex " << v;
    }
  }
}

TEST_P(ExactCostInvariance, TheCostLimitIsInTheUnitOfTheCost) {
  const IndexedMesh mesh = noisy_sphere(3, 0.03, 10);
  const std::vector<Contraction> all = contractions(mesh);
  const double limit = 1.00001 * all[all.size() / 2].cost;
  const auto first_above = std::ranges::find_if(all, [limit](const Contraction& c) { return c.cost > limit; });
  const auto expected = static_cast<std::uint64_t>(first_above - all.begin());
  EXPECT_GT(expected, 0U);
  for (const double unit : {1.0, 1000.0, 0.001}) {
    const DecimateTarget target = DecimateTarget::max_cost(limit * std::pow(unit, GetParam().dimension));
    const Decimation d = decimate(scaled(mesh, unit), target, GetParam().options);
    EXPECT_EQ(d.result.stop, StopReason::cost) << unit;
    EXPECT_EQ(d.result.n_contractions, expected) << unit;
  }
}

std::vector<CostSetting> exact_cost_settings() {
  std::vector<CostSetting> settings = all_cost_settings();
  std::erase_if(settings, [](const CostSetting& setting) { return !setting.has_exact_order(); });
  return settings;
}

std::string name_of(const testing::TestParamInfo<CostSetting>& test) {
  std::string name = test.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
}

INSTANTIATE_TEST_SUITE_P(Settings, CostInvariance, testing::ValuesIn(all_cost_settings()), name_of);
INSTANTIATE_TEST_SUITE_P(Settings, ExactCostInvariance, testing::ValuesIn(exact_cost_settings()), name_of);

}  // namespace
}  // namespace whittle::test
