#pragma once

#include <utility>
#include <vector>

#include "original/merged_points.hh"
#include "surface/vertex_blocks.hh"

namespace whittle::polishing {

/// Sums up over the feet of the original's points in each face of a mesh, on all threads, always in the same order.
/// The points merged into one vertex have their feet in its faces. A block of vertices adds to the faces whose corners
/// it has; what goes to other faces is added in the end.
/// \param add `add(sums, foot, weight)` adds a point to the sums of its face
/// \param of_face `of_face(f)` is where `Sums` are added to for a face
/// \throw Cancelled
template <class Sums, class Add, class OfFace>
void sum_over_feet(const Origins& origins, const Surface& mesh, const Add& add, const OfFace& of_face,
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
      for (std::size_t i = 0; i < points.feet().size(); ++i) {
        const Foot& foot = points.feet()[i];
        if (foot.face != invalid_index) add(at_corners[foot.corner], foot, points.weights()[i]);
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
