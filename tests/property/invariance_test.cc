#include <gtest/gtest.h>

#include <iostream>

#include "support/meshes.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/io/read.hh"
#include "whittle/metrics/distance.hh"

// The bunny in other units, rotated and far away: results must not change.

namespace whittle::test {
namespace {

struct Outcome {
  std::vector<std::array<Index, 2>> pairs;  ///< survivor, removed
  Decimation decimation;
  double mean_error = 0;  ///< model units
};

class BunnyInvariance : public testing::TestWithParam<Cost> {
 protected:
  void SetUp() override {
    WHITTLE_REAL_MESH_OR_SKIP(path, "bunny.obj");
    mesh_ = io::read_mesh(path).mesh;
    here_ = outcome_of(mesh_);
    std::cout << "as it is: " << here_.decimation.result.n_faces << " faces, mean error " << here_.mean_error << "\n";
  }
  static Outcome outcome_of(const IndexedMesh& mesh, unsigned threads = 0) {
    Outcome outcome;
    DecimateOptions options;
    options.cost = GetParam();
    options.threads = threads;
    options.listener = [&](const Contraction& c) { outcome.pairs.push_back({c.survivor, c.removed}); };
    outcome.decimation = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 10), options);
    outcome.mean_error = metrics::surface_distance(mesh, outcome.decimation.mesh, {.samples = 200'000}).mean;
    return outcome;
  }
  /// \param unit length in `there` of what is 1 in `here`
  void expect_near(const std::string& what, const Outcome& there, double unit, double tolerance) const {
    const double ratio = there.mean_error / unit / here_.mean_error;
    std::cout << what << ": " << there.decimation.result.n_faces << " faces, mean error x " << ratio << "\n";
    EXPECT_EQ(there.decimation.result.n_faces, here_.decimation.result.n_faces) << what;
    EXPECT_NEAR(ratio, 1, tolerance) << what;
  }

  IndexedMesh mesh_;
  Outcome here_;
};

TEST_P(BunnyInvariance, PowersOfTwoGiveTheSameBits) {
  for (const double factor : {1024.0, 1.0 / 1024}) {
    const Outcome there = outcome_of(scaled(mesh_, factor));
    EXPECT_EQ(there.pairs, here_.pairs);
    const auto& positions = there.decimation.mesh.positions;
    for (std::size_t v = 0; v < positions.size(); ++v) {
      ASSERT_EQ(positions[v], here_.decimation.mesh.positions[v] * factor) << v;
    }
  }
}

TEST_P(BunnyInvariance, PowersOfTenGiveTheSameErrorWithinHalfAPercent) {
  expect_near("x 1000", outcome_of(scaled(mesh_, 1000)), 1000, 0.005);
  expect_near("/ 1000", outcome_of(scaled(mesh_, 0.001)), 0.001, 0.005);
}

TEST_P(BunnyInvariance, TurnsGiveTheSameErrorWithinHalfAPercent) {
  for (const std::uint64_t seed : {1U, 2U}) expect_near("turned", outcome_of(rotated(mesh_, seed)), 1, 0.005);
}

TEST_P(BunnyInvariance, AMillionDiagonalsAwayTheErrorIsWithinFivePercent) {
  const double distance = 1e6 * diagonal(mesh_);
  expect_near("far away", outcome_of(moved(mesh_, Vec3(distance, -distance, distance))), 1, 0.05);
}

TEST_P(BunnyInvariance, ThreadsChangeNoBit) {
  for (unsigned threads = 1; threads <= 8; ++threads) {
    const Outcome there = outcome_of(mesh_, threads);
    EXPECT_EQ(there.pairs, here_.pairs) << threads;
    EXPECT_EQ(there.decimation.mesh.positions, here_.decimation.mesh.positions) << threads;
    EXPECT_EQ(there.decimation.mesh.faces, here_.decimation.mesh.faces) << threads;
  }
}

INSTANTIATE_TEST_SUITE_P(SlowCosts, BunnyInvariance, testing::Values(Cost::quadric, Cost::memoryless),
                         [](const auto& test) { return test.param == Cost::quadric ? "quadric" : "memoryless"; });

}  // namespace
}  // namespace whittle::test
