#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <vector>

#include "attributes/near_sheets.hh"
#include "attributes/surface_attribute.hh"

// Shared by measuring attributes at samples and at wedges.

namespace whittle::metrics {

/// Sheets that are no farther than the nearest one by this share of the diagonal, at a right angle, may be the right
/// ones: about as far as seams move when meshes are simplified to a tenth.
inline constexpr double sheet_tolerance_rel = 1e-3;

/// An attribute that both meshes have. Normals and colours are copied.
struct Shared {
  const Attribute* reference;
  const Attribute* test;
};

/// \param copies gets the normals and colours
std::vector<Shared> shared_attributes(const IndexedMesh& reference, const IndexedMesh& test,
                                      std::deque<Attribute>& copies);

/// Weights of the corners of a triangle, with sum 1, for a point in it. A triangle too thin counts as its longest side.
std::array<double, 3> barycentric(const std::array<Vec3, 3>& corners, const Vec3& point);

/// Compares one attribute at points of both surfaces.
class Comparer {
 public:
  Comparer(const SurfaceAttribute& from, const SurfaceAttribute& to)
      : from_(from),
        to_(to),
        from_blend_(from.blend()),
        to_blend_(to.blend()),
        here_(from.n_components()),
        there_(to.n_components()) {}

  const SurfaceAttribute& other() const { return to_; }

  /// \return false if the attribute isn't defined there
  bool set_here(std::size_t face, const std::array<double, 3>& weights) {
    return from_.value(face, weights, from_blend_, here_);
  }
  /// Infinite if the attribute isn't defined there.
  double deviation_at(std::size_t face, const std::array<double, 3>& weights) {
    if (!to_.value(face, weights, to_blend_, there_)) return std::numeric_limits<double>::infinity();
    return deviation(from_.kind(), here_, there_);
  }

 private:
  const SurfaceAttribute& from_;
  const SurfaceAttribute& to_;
  AttributeBlend from_blend_, to_blend_;
  std::vector<double> here_, there_;
};

/// The least deviation over the sheets that were found. Infinite if the attribute is defined on none of them.
/// \param point that they are near to \param noise_sq nearer than this is `point` itself
/// \param corners_of gives the corners of a face of the other surface, in the coordinates of `point`
template <class CornersOf>
double least_deviation(NearSheets& sheets, Comparer& comparer, const Vec3& point, double noise_sq,
                       const CornersOf& corners_of) {
  double least = std::numeric_limits<double>::infinity();
  sheets.for_each_sheet(comparer.other(), [&](const ClosestPoint& there) {
    const Vec3& at = there.distance_sq > noise_sq ? there.point : point;
    least = std::min(least, comparer.deviation_at(there.face, barycentric(corners_of(there.face), at)));
  });
  return least;
}

}  // namespace whittle::metrics
