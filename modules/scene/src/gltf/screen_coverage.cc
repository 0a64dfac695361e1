#include "gltf/screen_coverage.hh"

#include <Eigen/SVD>
#include <algorithm>
#include <numbers>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/metrics/certify.hh"

namespace whittle {
namespace {

/// Model units. That of a level that has vanished is the size of the mesh.
double error_of(const IndexedMesh& level, const IndexedMesh& mesh, double diagonal) {
  constexpr double accuracy = 0.01;  // the proven bound is what is used
  if (diagonal_of(level.positions) == 0) return diagonal;
  const metrics::LargestDistances largest = metrics::largest_distances(mesh, level, accuracy);
  return std::max(largest.forward.at_most, largest.backward.at_most);
}

/// The least diagonal of the mesh's bounding box where it is shown, over what becomes of a unit of length there: a node
/// that draws a mesh out in one direction shows a larger error beside the mesh.
double least_size(const IndexedMesh& mesh, std::span<const Eigen::Affine3d> places) {
  double least = diagonal_of(mesh.positions);
  for (const Eigen::Affine3d& place : places) {
    if (!place.matrix().allFinite()) continue;
    const Vec3 stretches = Eigen::JacobiSVD<Eigen::Matrix3d>(place.linear()).singularValues();
    if (stretches[2] > (1 - 1e-6) * stretches[0] || stretches[0] == 0) continue;  // equally in all directions
    const Eigen::Matrix3d relative = place.linear() / stretches[0];
    Box box;
    for (const Vec3& p : mesh.positions) box.extend(relative * p);
    least = std::min(least, diagonal_of(box));
  }
  return least;
}

/// How far compression moves the points of a level and of its mesh apart at most, as a share of the mesh's diagonal:
/// half a step of `gltf::WriteOptions` each, along each axis.
double rounding_of(const SceneOutput& output) {
  if (output.gltf.quantize) return std::numbers::sqrt3 / 32767;
  return output.gltf.compress ? std::numbers::sqrt3 / 65536 : 0;
}

}  // namespace

std::vector<double> screen_coverages(const IndexedMesh& mesh, std::span<const IndexedMesh> coarser,
                                     std::span<const Eigen::Affine3d> places, const SceneOutput& output) {
  constexpr double screen_width = 16.0 / 9;  // over its height
  const double diagonal = diagonal_of(mesh.positions);
  const double size = least_size(mesh, places);
  std::vector<double> coverages;
  double above = 1;
  for (const IndexedMesh& level : coarser) {
    const double error = error_of(level, mesh, diagonal) + rounding_of(output) * diagonal;
    if (error > 0) {
      // The sphere has this diameter, over the screen's height, where the error is as large as it may be.
      const double diameter = size / error * output.level_error_rel;
      above = std::min(above, std::numbers::pi / 4 * diameter * diameter / screen_width);
    }
    coverages.push_back(above);
  }
  coverages.push_back(0);
  return coverages;
}

}  // namespace whittle
