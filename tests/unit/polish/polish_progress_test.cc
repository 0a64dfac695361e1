#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
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

/// Cancels at the start of a stage, or at the next report after it. How often a stage reports depends on the time it
/// takes.
class CancelAt {
 public:
  CancelAt(unsigned stage, bool is_after_start) : stage_(stage), is_after_start_(is_after_start) {}

  bool operator()(const TaskProgress& progress) {
    const bool is_start = current_ != progress.stage;
    if (is_start) ++n_started_;
    current_ = progress.stage;
    return n_started_ < stage_ || (n_started_ == stage_ && is_start && is_after_start_);
  }

 private:
  unsigned stage_;  ///< 1 = the first
  bool is_after_start_;
  unsigned n_started_ = 0;
  std::string current_;
};

/// Wherever it is cancelled, the mesh is the result of the passes completed before.
TEST(PolishProgress, LeavesWhatTheLastPassMadeWhenCancelled) {
  const Case c;
  std::vector<Case::Polished> expected;
  for (unsigned passes = 0; passes <= n_passes; ++passes) expected.push_back(c.polished(passes, {}));
  ASSERT_EQ(expected.back().result.n_passes, n_passes) << "else this tests little";
  for (const bool is_after_start : {false, true}) {
    std::vector<unsigned> n_seen(n_passes + 1);
    for (unsigned stage = 1;; ++stage) {
      CancelAt cancel(stage, is_after_start);
      const auto run = c.polished(n_passes, std::ref(cancel));
      if (!run.result.cancelled) break;
      const auto& wanted = expected[run.result.n_passes];
      ++n_seen[run.result.n_passes];
      EXPECT_EQ(run.mesh.positions, wanted.mesh.positions);
      EXPECT_EQ(run.mesh.faces, wanted.mesh.faces);
      EXPECT_EQ(run.result.n_moved, wanted.result.n_moved);
    }
    for (unsigned passes = 0; passes < n_passes; ++passes) EXPECT_GE(n_seen[passes], 4U) << passes;
  }
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
