#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/proof/linked_faces.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle {

/// A mesh that triangles are proven to be near to.
class TargetSurface final : public ProofTarget {
 public:
  /// \param mesh must outlive it
  /// \param frame must make it about as large as 1
  /// \param limits of each face, in the frame, or empty
  /// \param limit the greatest of them: a face counts as as much farther as its limit is less
  TargetSurface(const IndexedMesh& mesh, const Frame& frame, std::span<const double> limits = {}, double limit = 0);

  /// Builds the tree that `nearest` needs, if there is none. \throw Cancelled
  void build_tree(detail::ProgressMeter* meter) const;

  LinkedFaces faces() const override { return {in_frame_.positions, in_frame_.faces, beyond_, offsets_}; }
  /// Any number of threads may call. The first few times it does without a tree, if there is none.
  NearFace nearest(const Vec3& point, Index hint) const override;

 private:
  NearFace nearest_without_tree(const Vec3& point) const;

  IndexedMesh in_frame_;
  std::vector<FacesBeyond> beyond_;
  std::vector<double> offsets_;
  mutable std::atomic<int> n_without_tree_{0};  ///< points looked up without it
  mutable std::atomic<bool> has_tree_{false};
  mutable std::once_flag once_;
  mutable std::optional<TriangleTree> tree_;
};

}  // namespace whittle
