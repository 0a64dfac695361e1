#pragma once

#include <array>
#include <span>
#include <vector>

#include "whittle/core/attribute_blend.hh"
#include "whittle/core/indexed_mesh.hh"

namespace whittle::metrics {

/// An attribute as a function on the surface of a mesh. The mesh must outlive it.
class SurfaceAttribute {
 public:
  SurfaceAttribute(const IndexedMesh& mesh, const Attribute& attribute);

  AttributeKind kind() const { return attribute_.kind; }
  /// Number of components of an interpolated value. For joint weights three times as many as at a corner: corners may
  /// have different joints.
  std::size_t n_components() const;
  AttributeBlend blend() const { return {attribute_.kind, attribute_.n_components}; }

  /// The value at a point of a face. \param barycentric weights of the corners, with sum 1 \param blend from `blend()`,
  /// to be used again \return false if it is a direction that isn't defined there
  bool value(std::size_t face, const std::array<double, 3>& barycentric, AttributeBlend& blend,
             std::span<double> to) const;

  /// A number that corners have in common if they are at the same vertex and have the same value.
  Index continuity(std::size_t face, std::size_t corner) const { return first_equal_[mesh_.wedge(face, corner)]; }

 private:
  const IndexedMesh& mesh_;
  const Attribute& attribute_;
  std::vector<Index> first_equal_;  ///< for each wedge the first one of its vertex with the same value
};

/// The deviation of two values (`AttributeDeviation`).
/// \param a, b of the same kind; the numbers of components of joint weights may differ
double deviation(AttributeKind kind, std::span<const double> a, std::span<const double> b);

}  // namespace whittle::metrics
