#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "whittle/core/detail/large_array.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/proof/linked_faces.hh"
#include "whittle/core/geometry/triangle_tree.hh"

namespace whittle {

/// A mesh as the target of proofs that triangles are near it.
class TargetSurface final : public ProofTarget {
 public:
  /// \param mesh must outlive it
  /// \param frame in which the mesh has about size 1
  /// \param limits per face, in the frame, or empty
  /// \param limit largest of `limits`. A face with a smaller limit has the difference added to its distance
  TargetSurface(const IndexedMesh& mesh, const Frame& frame, std::span<const double> limits = {}, double limit = 0);

  /// Builds the tree for `nearest`, unless it is built. \throw Cancelled
  void build_tree(detail::ProgressMeter* meter) const;

  LinkedFaces faces() const override { return {in_frame_.positions, in_frame_.faces, beyond_, offsets_}; }
  /// The nearest face. Any number of threads may call. The first few calls search without a tree.
  NearFace nearest(const Vec3& point, Index hint) const override;

 private:
  NearFace nearest_without_tree(const Vec3& point) const;

  IndexedMesh in_frame_;
  LargeArray<FacesBeyond> beyond_;
  std::vector<double> offsets_;
  mutable std::atomic<int> n_without_tree_{0};  ///< number of searches without the tree
  mutable std::atomic<bool> has_tree_{false};
  mutable std::once_flag once_;
  mutable std::optional<TriangleTree> tree_;
};

}  // namespace whittle
