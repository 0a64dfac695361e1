#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "whittle/core/indexed_mesh.hh"

// Distances between surfaces by many points. This shares no code with `metrics::certify`, which it judges.

namespace whittle::bench {

/// Finds the distance to a set of triangles; their corners may coincide.
class FaceTree {
 public:
  /// \param mesh has faces, and outlives the tree
  explicit FaceTree(const IndexedMesh& mesh);
  double distance(const Vec3& point) const;

 private:
  struct Node {
    Vec3 low;
    Vec3 high;
    std::size_t begin = 0;  ///< in `faces_`
    std::size_t end = 0;
    std::size_t second_child = 0;  ///< the first one is the next node; 0 = a leaf
  };
  void build(std::size_t begin, std::size_t end);
  void lessen(double& distance, const Vec3& point, std::size_t node) const;

  const IndexedMesh& mesh_;
  std::vector<Index> faces_;
  std::vector<Node> nodes_;
};

/// The largest distance of points of one surface from the other: all corners of its faces, and random points by area,
/// at least one a face. \pre both have faces
double sampled_distance(const IndexedMesh& from, const FaceTree& to, std::size_t n_samples, std::uint64_t seed);

/// The open border as faces of which two corners are one.
IndexedMesh border_as_faces(const IndexedMesh& mesh);

}  // namespace whittle::bench
