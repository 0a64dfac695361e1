#pragma once

#include <span>
#include <string>
#include <vector>

#include "whittle/core/attribute.hh"
#include "whittle/core/indexed_mesh.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::metrics {

/// From the samples of one surface to the other surface.
struct DirectedAttributeDeviation {
  double mean = 0.0;  ///< Of the samples.
  double max = 0.0;   ///< Of the samples: a lower bound.
};

/// Deviation of an attribute between two surfaces. The unit depends on the kind:
///
/// |kind|deviation of two values|
/// |-|-|
/// |texcoord|Euclidean distance; 1 is the width of the texture|
/// |normal, tangent|the angle between both directions, degrees, [0, 180]|
/// |color|Euclidean distance of red, green, blue and opacity, each in [0, 1]|
/// |joint_weights|half the sum of the differences of the weights, joint by joint, [0, 1]|
/// |displacement, direction|Euclidean distance, units of the attribute|
/// |scalar|absolute difference; of several components the Euclidean distance|
/// |category|1 if they differ, otherwise 0; so the mean is the share of the area where they differ|
struct AttributeDeviation {
  std::string name;  ///< As in the meshes. "NORMAL" and "COLOR_0" for `IndexedMesh::normals` and `colors`.
  AttributeKind kind = AttributeKind::scalar;
  double mean = 0.0;                    ///< Mean of both directions' means.
  double max = 0.0;                     ///< The larger of both directions' maxima.
  DirectedAttributeDeviation forward;   ///< From the reference to the test surface.
  DirectedAttributeDeviation backward;  ///< From the test surface to the reference.
};

/// Deviations of the attributes of vertices and corners that both meshes have, by name, kind and number of components
/// (any number of joints). In the order of the reference; `normals` and `colors` come first.
///
/// At each sample the value is interpolated between the corners of its face, and compared with the value at the closest
/// point of the other surface. Near a seam, or between two sheets, the closest point may lie on the wrong side, with
/// another value. So a sample is also compared with other sheets that are nearly as near, and the least deviation
/// counts. A sheet is a set of faces where the attribute is continuous: they are connected over vertices at which both
/// have the same value. Nearly as near: d² ≤ d₀² + (diagonal/1000)², with the distance d₀ of the closest point, and the
/// larger diagonal of both boxes; the 64 nearest of these faces count.
///
/// Directions of length 0 count as absent; an attribute that can't be compared anywhere is left out.
/// \throw as `surface_distance`
std::vector<AttributeDeviation> attribute_deviations(const IndexedMesh& reference, const IndexedMesh& test,
                                                     const DistanceOptions& options = {});

/// The deviations of one attribute at the wedges of a mesh, in the unit of `AttributeDeviation`.
struct WedgeDeviations {
  std::string name;
  AttributeKind kind = AttributeKind::scalar;
  std::vector<double> values;  ///< W; 0 at unused wedges, and where the attribute can't be compared
};

/// `attribute_deviations` from one surface to the other, at each wedge instead of samples.
/// \param kinds of attributes to compare
/// \param threads 0 = all cores; the result is the same for any number
/// \throw std::invalid_argument as `surface_distance`
std::vector<WedgeDeviations> attribute_deviations_at_wedges(const IndexedMesh& mesh, const IndexedMesh& other,
                                                            std::span<const AttributeKind> kinds, unsigned threads = 0);

}  // namespace whittle::metrics
