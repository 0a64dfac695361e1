#include <algorithm>
#include <deque>
#include <limits>
#include <vector>

#include "attributes/comparison.hh"
#include "attributes/near_sheets.hh"
#include "noise.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/wedges.hh"
#include "whittle/metrics/attribute_deviation.hh"
#include "working_scale.hh"

namespace whittle::metrics {

namespace {

/// A corner of a mesh.
struct MeshCorner {
  Index face = invalid_index;
  std::uint8_t number = 0;
};

std::vector<MeshCorner> corners_of_wedges(const IndexedMesh& mesh) {
  std::vector<MeshCorner> corners(n_wedges(mesh));
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    for (std::uint8_t k = 0; k < 3; ++k) corners[mesh.wedge(f, k)] = {f, k};
  }
  return corners;
}

struct FromWedges {
  const IndexedMesh& mesh;
  const IndexedMesh& other;
  TriangleTree tree;  ///< of `other`
  std::vector<MeshCorner> corners;
  double noise_sq, sheet_tolerance_sq;
};

/// Fills the values of some wedges.
void measure_wedges(const FromWedges& from, std::size_t begin, std::size_t end, std::vector<Comparer> comparers,
                    std::vector<WedgeDeviations>& deviations) {
  const auto corners_of = [&](std::size_t face) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = from.other.positions[from.other.faces[face][k]] - from.tree.origin();
    }
    return corners;
  };
  NearSheets sheets;
  Index hint = invalid_index;
  for (std::size_t w = begin; w < end; ++w) {
    const auto [face, number] = from.corners[w];
    if (face == invalid_index) continue;
    const Vec3 point = from.mesh.positions[from.mesh.faces[face][number]] - from.tree.origin();
    const ClosestPoint nearest = from.tree.nearest_local(point, hint);
    hint = nearest.face;
    sheets.find(from.tree, point, nearest.distance_sq + from.sheet_tolerance_sq);
    std::array<double, 3> here{};
    here[number] = 1;
    for (std::size_t a = 0; a < comparers.size(); ++a) {
      if (!comparers[a].set_here(face, here)) continue;
      const double least = least_deviation(sheets, comparers[a], point, from.noise_sq, corners_of);
      if (least < std::numeric_limits<double>::infinity()) deviations[a].values[w] = least;
    }
  }
}

}  // namespace

std::vector<WedgeDeviations> attribute_deviations_at_wedges(const IndexedMesh& mesh, const IndexedMesh& other,
                                                            std::span<const AttributeKind> kinds, unsigned threads) {
  const Box box = bounds_of(mesh), other_box = bounds_of(other);
  if (const double scale = working_scale({box, other_box}); scale != 1.0) {
    const auto rescaled = [scale](IndexedMesh it) {
      for (Vec3& p : it.positions) p *= scale;
      return it;
    };
    return attribute_deviations_at_wedges(rescaled(mesh), rescaled(other), kinds, threads);
  }
  std::deque<Attribute> copies;
  std::vector<Shared> shared = shared_attributes(mesh, other, copies);
  std::erase_if(shared, [&](const Shared& one) {
    return std::find(kinds.begin(), kinds.end(), one.reference->kind) == kinds.end();
  });
  if (shared.empty()) return {};
  const double diagonal = std::max(diagonal_of(box), diagonal_of(other_box));
  const double noise = noise_rel * diagonal, tolerance = sheet_tolerance_rel * diagonal;
  const FromWedges from{
      mesh, other, TriangleTree(other, center_of(box)), corners_of_wedges(mesh), noise * noise, tolerance * tolerance};
  std::deque<SurfaceAttribute> attributes;
  std::vector<Comparer> comparers;
  std::vector<WedgeDeviations> deviations;
  for (const Shared& one : shared) {
    const SurfaceAttribute& here = attributes.emplace_back(mesh, *one.reference);
    comparers.emplace_back(here, attributes.emplace_back(other, *one.test));
    deviations.push_back({one.reference->name, one.reference->kind, std::vector<double>(from.corners.size())});
  }
  for_each_range(from.corners.size(), threads,
                 [&](std::size_t begin, std::size_t end) { measure_wedges(from, begin, end, comparers, deviations); });
  return deviations;
}

}  // namespace whittle::metrics
