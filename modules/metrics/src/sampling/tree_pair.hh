#pragma once

#include <optional>

#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle::metrics {

/// The search trees of two meshes, with the same origin. They are built at the same time if there are threads.
class TreePair {
 public:
  /// \param meter, workers are told the progress, and may cancel
  /// \param of_reference keeps its tree, which is built if it is empty; must outlive this
  TreePair(const IndexedMesh& reference, const IndexedMesh& test, const Vec3& origin, const detail::Workers& workers,
           detail::ProgressMeter& meter, std::optional<TriangleTree>& of_reference);

  const TriangleTree& reference() const { return *reference_; }
  const TriangleTree& test() const { return *test_; }

 private:
  const std::optional<TriangleTree>& reference_;
  std::optional<TriangleTree> test_;
};

}  // namespace whittle::metrics
