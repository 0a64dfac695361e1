#include "gltf/screen_coverage.hh"

#include <algorithm>
#include <numbers>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/metrics/distance.hh"

namespace whittle {
namespace {

/// Model units. That of a level that has vanished is the size of the mesh.
double error_of(const IndexedMesh& level, const IndexedMesh& mesh, double diagonal) {
  constexpr std::size_t samples = 20'000;  // beside all vertices
  const bool has_vanished = diagonal_of(level.positions) == 0;
  return has_vanished ? diagonal : metrics::surface_distance(mesh, level, {.samples = samples}).max;
}

}  // namespace

std::vector<double> screen_coverages(const IndexedMesh& mesh, std::span<const IndexedMesh> coarser) {
  constexpr double screen = 1920.0 * 1080.0;  // pixels
  const double diagonal = diagonal_of(mesh.positions);
  std::vector<double> coverages;
  double above = 1;
  for (const IndexedMesh& level : coarser) {
    const double error = error_of(level, mesh, diagonal);
    // The sphere has this diameter where the error is a pixel.
    const double pixels = error > 0 ? diagonal / error : screen;
    above = std::min(above, std::numbers::pi / 4 * pixels * pixels / screen);
    coverages.push_back(above);
  }
  coverages.push_back(0);
  return coverages;
}

}  // namespace whittle
