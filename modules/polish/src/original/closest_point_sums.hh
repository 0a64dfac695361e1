#pragma once

#include <utility>
#include <vector>

#include "original/merged_points.hh"
#include "surface/vertex_blocks.hh"

namespace whittle::polishing {

/// Sums over the original's closest points in each face of a mesh, on all threads, always in the same order. Points
/// merged into one vertex have their closest points in its faces. A block of vertices adds to faces with all corners in
/// the block; sums for other faces are added in the end.
/// \param add `add(sums, closest, weight)` adds a closest point to the sums of its face
/// \param of_face `of_face(f)` returns the `Sums` of face f
/// \throw Cancelled
template <class Sums, class Add, class OfFace>
void sum_over_closest_points(const Origins& origins, const Surface& mesh, const Add& add, const OfFace& of_face,
                             const detail::Workers& workers) {
  const VertexBlocks blocks(origins.n_vertices());
  std::vector<std::vector<std::pair<Index, Sums>>> left_over(blocks.size());
  for_each_block(blocks.size(), workers, [&](std::size_t block) {
    MergedPoints points(origins, mesh, blocks.end(block));
    std::vector<Sums> at_corners;
    for (Index v = blocks.begin(block); v < blocks.end(block); ++v) {
      const std::span<const Corner> corners = mesh.corners.of(v);
      at_corners.assign(corners.size(), Sums{});
      points.find(v);
      for (std::size_t i = 0; i < points.closest_points().size(); ++i) {
        const ClosestFacePoint& closest = points.closest_points()[i];
        if (closest.face != invalid_index) add(at_corners[closest.corner], closest, points.weights()[i]);
      }
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Index f = corners[i].face;
        if (blocks.is_in_one(mesh.faces[f])) {
          of_face(f) += at_corners[i];
        } else {
          left_over[block].push_back({f, at_corners[i]});
        }
      }
    }
  });
  for (const auto& of_block : left_over) {
    for (const auto& [f, sums] : of_block) of_face(f) += sums;
  }
}

}  // namespace whittle::polishing
