// What no result of decimate may depend on: the unit, the place, the numbering, the threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::test {
namespace {

std::vector<Contraction> contractions(const IndexedMesh& mesh, DecimateOptions options = {}) {
  std::vector<Contraction> done;
  options.listener = [&](const Contraction& c) { done.push_back(c); };
  decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 10), options);
  return done;
}

bool same_pairs(const std::vector<Contraction>& a, const std::vector<Contraction>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contraction& x, const Contraction& y) {
    return x.survivor == y.survivor && x.removed == y.removed;
  });
}

TEST(DecimateInvariance, PowersOfTwoAsTheUnitChangeNoBit) {
  for (const auto& [name, mesh] : all_meshes()) {
    const std::vector<Contraction> here = contractions(mesh);
    for (const double factor : {0x1p10, 0x1p-10, 0x1p200, 0x1p-200}) {
      const std::vector<Contraction> there = contractions(scaled(mesh, factor));
      ASSERT_TRUE(same_pairs(here, there)) << name << " × " << factor;
      for (std::size_t i = 0; i < here.size(); ++i) ASSERT_EQ(there[i].position, here[i].position * factor) << name;
    }
  }
}

TEST(DecimateInvariance, OtherUnitsTurnsAndPlacesGiveTheSameContractions) {
  // Random heights, so no two costs differ by rounding only.
  const IndexedMesh mesh = noisy_sphere(4, 0.02, 10);
  const std::vector<Contraction> here = contractions(mesh);
  for (const double factor : {1000.0, 0.001})
    EXPECT_TRUE(same_pairs(here, contractions(scaled(mesh, factor)))) << factor;
  for (const std::uint64_t seed : {1U, 2U, 3U})
    EXPECT_TRUE(same_pairs(here, contractions(rotated(mesh, seed)))) << seed;
  EXPECT_TRUE(same_pairs(here, contractions(moved(mesh, {3e3, -2e3, 5e3}))));
}

TEST(DecimateInvariance, AnotherOrderOfVerticesAndFacesGivesTheSameSurface) {
  const IndexedMesh mesh = noisy_sphere(4, 0.02, 11);
  const Decimation here = decimate(mesh, DecimateTarget::faces(500));
  const Permuted other = permuted(mesh, 12);
  const Decimation there = decimate(other.mesh, DecimateTarget::faces(500));
  ASSERT_EQ(there.mesh.positions.size(), here.mesh.positions.size());
  for (Index v = 0; v < other.old_vertex.size(); ++v) {
    const Vec3& p = there.mesh.positions[there.vertex_map[v]];
    const Vec3& q = here.mesh.positions[here.vertex_map[other.old_vertex[v]]];
    // Sums in another order: rounding, amplified by the condition of the solve (at most 1 / regularisation).
    ASSERT_NEAR((p - q).norm(), 0, 1e-6) << "vertex " << v;
  }
}

TEST(DecimateInvariance, ThreadsChangeNoBit) {
  const IndexedMesh mesh = noisy_sphere(6, 0.01, 13);
  DecimateOptions options;
  options.threads = 1;
  const Decimation one = decimate(mesh, DecimateTarget::faces(5000), options);
  for (const unsigned threads : {2U, 3U, 8U, 0U}) {
    options.threads = threads;
    const Decimation many = decimate(mesh, DecimateTarget::faces(5000), options);
    EXPECT_EQ(many.mesh.positions, one.mesh.positions) << threads;
    EXPECT_EQ(many.mesh.faces, one.mesh.faces) << threads;
  }
}

}  // namespace
}  // namespace whittle::test
