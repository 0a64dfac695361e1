#include <gtest/gtest.h>

#include "support/shapes/shapes.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/nearest_vertices.hh"
#include "whittle/metrics/self_intersections.hh"

namespace whittle::metrics {
namespace {

const IndexedMesh& noisy() {
  static const IndexedMesh mesh = test::noisy_sphere(5, 0.05, 1);
  return mesh;
}
const IndexedMesh& other() {
  static const IndexedMesh mesh = test::sphere(4);
  return mesh;
}

/// Runs `task(progress)` to its end, then cancels it at every report. \return the number of reports
template <class Task>
int run_and_cancel(const Task& task) {
  int n_reports = 0;
  double last = 0;
  task([&](const TaskProgress& progress) {
    EXPECT_GE(progress.fraction, last);
    last = progress.fraction;
    ++n_reports;
    return true;
  });
  EXPECT_EQ(last, 1);
  // The next run may have fewer reports, because those within a stage depend on time. The first one always comes.
  EXPECT_THROW(task([](const TaskProgress&) { return false; }), Cancelled);
  return n_reports;
}

TEST(MetricsProgress, IsReportedAndMayCancelDistances) {
  const SurfaceDistance expected = surface_distance(noisy(), other(), {.samples = 50'000});
  for (const unsigned threads : {1U, 2U}) {
    const int n_reports = run_and_cancel([&](const ProgressCallback& progress) {
      const DistanceOptions options{.samples = 50'000, .threads = threads, .progress = progress};
      EXPECT_EQ(surface_distance(noisy(), other(), options).mean, expected.mean);
    });
    EXPECT_GE(n_reports, 4);
  }
}

TEST(MetricsProgress, IsReportedAndMayCancelIntersections) {
  const auto expected = self_intersections(noisy(), 1);
  EXPECT_GE(run_and_cancel([&](const ProgressCallback& progress) {
              EXPECT_EQ(self_intersections(noisy(), 2, progress), expected);
            }),
            3);
}

TEST(MetricsProgress, IsReportedAndMayCancelNearestVertices) {
  const auto expected = nearest_vertices(noisy(), other(), 1);
  EXPECT_GE(run_and_cancel([&](const ProgressCallback& progress) {
              EXPECT_EQ(nearest_vertices(noisy(), other(), 2, progress), expected);
            }),
            3);
}

}  // namespace
}  // namespace whittle::metrics
