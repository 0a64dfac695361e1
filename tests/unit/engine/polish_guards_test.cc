#include <gtest/gtest.h>

#include <vector>

#include "support/shapes.hh"
#include "support/suites.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/polish.hh"
#include "whittle/metrics/shape.hh"

// What polishing must not do to a mesh, on meshes where it would.
namespace whittle::test {
namespace {

struct Polished {
  IndexedMesh before;
  IndexedMesh after;
};

Polished polished(const IndexedMesh& original, double ratio, unsigned passes) {
  DecimateOptions options;
  options.cost = Cost::memoryless;
  Decimation d = decimate(
      original, {.faces = static_cast<std::uint64_t>(ratio * static_cast<double>(original.faces.size()))}, options);
  Polished both{d.mesh, std::move(d.mesh)};
  polish(original, d.vertex_map, both.after, {.passes = passes});
  return both;
}

std::vector<NamedMesh> rough_meshes() {
  return {{"sphere", noisy_sphere(5, 0.05, 1)},
          {"rough sphere", noisy_sphere(5, 0.1, 2)},
          {"torus", noisy_torus(120, 60, 1, 0.4, 0.05, 3)},
          {"rough torus", noisy_torus(120, 60, 1, 0.4, 0.1, 3)},
          {"knot", knot(200, 24)},
          {"terrain", terrain(60, 4)},
          {"grid", noisy_grid(50, 50, 0.2, 6)}};
}

TEST(PolishGuards, MakeNoFolds) {
  for (const auto& [name, original] : rough_meshes()) {
    for (const double ratio : {0.5, 0.1, 0.02}) {
      SCOPED_TRACE(name + " to " + std::to_string(ratio));
      const Polished mesh = polished(original, ratio, 3);
      EXPECT_LE(metrics::shape(mesh.after).folds, metrics::shape(mesh.before).folds);
    }
  }
}

}  // namespace
}  // namespace whittle::test
