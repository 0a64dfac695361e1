// The surface that a progress callback may look at (`Progress::surface`).
#include <gtest/gtest.h>

#include <thread>

#include "support/shapes/shapes.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::test {
namespace {

/// A surface that was looked at.
struct Moment {
  std::uint64_t n_faces_told;
  IndexedMesh surface;
};

struct Watched {
  std::vector<Moment> moments;
  Decimation result;
};

/// Looks at the surface at every `nth` call.
Watched watch(const IndexedMesh& mesh, std::uint64_t n_faces, DecimateOptions options, std::size_t nth) {
  Watched watched;
  std::size_t n_calls = 0;
  const std::thread::id caller = std::this_thread::get_id();
  options.progress = [&](const Progress& progress) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    if (progress.surface && n_calls++ % nth == 0) watched.moments.push_back({progress.n_faces, progress.surface()});
    return true;
  };
  watched.result = decimate(mesh, DecimateTarget::faces(n_faces), options);
  return watched;
}

bool is_closed(const IndexedMesh& mesh) {
  const metrics::Topology topology = metrics::topology(mesh);
  return topology.boundary_edges == 0 && topology.nonmanifold_edges == 0 && topology.components == 1;
}

void expect_same_mesh(const Decimation& a, const Decimation& b) {
  EXPECT_EQ(a.mesh.positions, b.mesh.positions);
  EXPECT_EQ(a.mesh.faces, b.mesh.faces);
}

constexpr std::size_t all_calls = 1;

TEST(SurfaceNow, IsTheMeshOnItsWayInOneQueue) {
  const IndexedMesh mesh = noisy_sphere(5, 0.01, 1);
  DecimateOptions options;
  options.threads = 1;
  const Watched watched = watch(mesh, 500, options, all_calls);
  ASSERT_GE(watched.moments.size(), 3U);
  const double diagonal = diagonal_of(bounds_of(mesh));
  for (const auto& [n_faces, surface] : watched.moments) {
    EXPECT_EQ(surface.faces.size(), n_faces);
    EXPECT_TRUE(is_closed(surface)) << n_faces;
    EXPECT_NEAR(diagonal_of(bounds_of(surface)), diagonal, 0.05 * diagonal);
  }
  EXPECT_EQ(watched.moments.front().surface.faces.size(), mesh.faces.size());
  expect_same_mesh(watched.result, decimate(mesh, DecimateTarget::faces(500), options));
}

TEST(SurfaceNow, IsTheMeshOnItsWayInBlocksAndRounds) {
  const IndexedMesh mesh = noisy_sphere(7, 0.01, 1);
  for (const unsigned threads : {1U, 4U}) {
    SCOPED_TRACE(threads);
    DecimateOptions options;
    options.cost = Cost::memoryless;
    options.threads = threads;
    ASSERT_TRUE(goes_in_blocks(mesh, DecimateTarget::faces(2000), options));
    const Watched watched = watch(mesh, 2000, options, 8);
    ASSERT_GE(watched.moments.size(), 3U);
    // Those of one thread are there after each block.
    EXPECT_LT(watched.moments.back().surface.faces.size(), mesh.faces.size() / 2);
    std::size_t n_before = mesh.faces.size();
    for (const auto& [n_faces, surface] : watched.moments) {
      EXPECT_TRUE(is_closed(surface)) << n_faces;
      EXPECT_LE(surface.faces.size(), n_before);
      n_before = surface.faces.size();
    }
    expect_same_mesh(watched.result, decimate(mesh, DecimateTarget::faces(2000), options));
  }
}

TEST(SurfaceNow, LiesWhereTheMeshLies) {
  for (const Vec3& far : {Vec3(0, 0, 0), Vec3(1e6, -2e6, 3e6)}) {
    for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
      IndexedMesh mesh = noisy_sphere(6, 0.01, 1);
      for (Vec3& position : mesh.positions) position = 1000 * position + far;
      DecimateOptions options;
      options.cost = cost;
      const Watched watched = watch(mesh, 1000, options, 4);
      ASSERT_FALSE(watched.moments.empty());
      for (const Moment& moment : watched.moments) {
        const Box box = bounds_of(moment.surface);
        EXPECT_LT((box.center() - far).norm(), 100) << far.transpose();
        EXPECT_NEAR(box.sizes().maxCoeff(), 2000, 200);
      }
    }
  }
}

}  // namespace
}  // namespace whittle::test
