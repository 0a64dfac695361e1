#pragma once

#include <optional>

#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle::metrics {

/// The search trees of two meshes, with the same origin. They are built at the same time if there are threads.
class TreePair {
 public:
  /// \param meter, workers are told the progress, and may cancel
  TreePair(const IndexedMesh& reference, const IndexedMesh& test, const Vec3& origin, const detail::Workers& workers,
           detail::ProgressMeter& meter);

  const TriangleTree& reference() const { return *reference_; }
  const TriangleTree& test() const { return *test_; }

 private:
  std::optional<TriangleTree> reference_;
  std::optional<TriangleTree> test_;
};

}  // namespace whittle::metrics
