#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "support/shapes/shapes.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/polish/polish.hh"

namespace whittle::test {
namespace {

constexpr unsigned n_passes = 3;

struct Case {
  IndexedMesh original = noisy_sphere(5, 0.05, 1);
  Decimation decimation;

  Case() {
    DecimateOptions options;
    options.cost = Cost::memoryless;
    decimation = decimate(original, DecimateTarget::faces(original.faces.size() / 4), options);
  }

  struct Polished {
    IndexedMesh mesh;
    PolishResult result;
  };
  Polished polished(unsigned passes, const ProgressCallback& progress) const {
    Polished run{decimation.mesh, {}};
    run.result =
        polish(original, decimation.vertex_map, run.mesh, {.passes = passes, .flips = true, .progress = progress});
    return run;
  }
};

TEST(PolishProgress, ComesInOrderAndChangesNothing) {
  const Case c;
  std::vector<std::string> stages;
  double last = 0;
  double begun = -1;
  const auto told = c.polished(n_passes, [&](const TaskProgress& progress) {
    EXPECT_GE(progress.fraction, last);
    last = progress.fraction;
    if (!stages.empty() && stages.back() == progress.stage) return true;
    stages.emplace_back(progress.stage);
    EXPECT_GT(progress.fraction, begun) << progress.stage << " begins later than the stage before";
    begun = progress.fraction;
    return true;
  });
  EXPECT_EQ(last, 1);
  EXPECT_FALSE(told.result.cancelled);
  ASSERT_GT(told.result.n_passes, 1U) << "else this tests little";
  EXPECT_GE(stages.size(), 1 + 5 * told.result.n_passes);
  EXPECT_EQ(stages.front(), "preparing");
  const auto silent = c.polished(n_passes, {});
  EXPECT_EQ(told.mesh.positions, silent.mesh.positions);
  EXPECT_EQ(told.mesh.faces, silent.mesh.faces);
  EXPECT_EQ(told.result.rms_after, silent.result.rms_after);
}

/// After cancelling at any report, the mesh is the result of the passes completed before.
TEST(PolishProgress, LeavesWhatTheLastPassMadeWhenCancelled) {
  const Case c;
  std::vector<Case::Polished> expected;
  for (unsigned passes = 0; passes <= n_passes; ++passes) expected.push_back(c.polished(passes, {}));
  std::vector<unsigned> n_seen(n_passes + 1);
  for (int last_call = 0;; ++last_call) {
    int n_calls = 0;
    const auto run = c.polished(n_passes, [&](const TaskProgress&) { return n_calls++ < last_call; });
    if (!run.result.cancelled) break;
    const auto& wanted = expected[run.result.n_passes];
    ++n_seen[run.result.n_passes];
    EXPECT_EQ(run.mesh.positions, wanted.mesh.positions);
    EXPECT_EQ(run.mesh.faces, wanted.mesh.faces);
    EXPECT_EQ(run.result.n_moved, wanted.result.n_moved);
  }
  for (unsigned passes = 0; passes < n_passes; ++passes) EXPECT_GT(n_seen[passes], 3U);
}

TEST(PolishProgress, AsksOftenOnAMillionFaces) {
  constexpr Index n_around = 1000, n_across = 500, n_coarse_around = 400, n_coarse_across = 200;
  const IndexedMesh original = noisy_torus(n_around, n_across, 1, 0.35, 0.001, 1);
  IndexedMesh mesh = torus(n_coarse_around, n_coarse_across);
  std::vector<Index> map;
  for (Index i = 0; i < n_around; ++i) {
    for (Index j = 0; j < n_across; ++j) {
      map.push_back(i * n_coarse_around / n_around * n_coarse_across + j * n_coarse_across / n_across);
    }
  }
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  Clock::duration longest{};
  const PolishResult result =
      polish(original, map, mesh, {.flips = true, .threads = 1, .progress = [&](const TaskProgress&) {
                                     const auto now = Clock::now();
                                     longest = std::max(longest, now - last);
                                     last = now;
                                     return true;
                                   }});
  EXPECT_EQ(result.n_passes, 1U);
  // Ten times the expected value: other programs may run at the same time.
  EXPECT_LT(longest, std::chrono::seconds(3));
  RecordProperty("longest_ms", static_cast<int>(longest / std::chrono::milliseconds(1)));
}

}  // namespace
}  // namespace whittle::test
