#pragma once

#include <algorithm>

#include "whittle/core/indexed_mesh.hh"

namespace whittle::polishing {

/// The vertices of a mesh in blocks of successive numbers. They depend on the mesh alone, so work that is done block by
/// block has one order for any number of threads.
class VertexBlocks {
 public:
  explicit VertexBlocks(std::size_t n_vertices) : n_vertices_(n_vertices) {
    constexpr std::size_t enough = 64;  // blocks for all threads
    constexpr std::size_t longest = 1024;
    length_ = std::clamp<std::size_t>(n_vertices / enough, 1, longest);
  }

  std::size_t size() const { return (n_vertices_ + length_ - 1) / length_; }  ///< number of blocks
  Index begin(std::size_t block) const { return static_cast<Index>(block * length_); }
  Index end(std::size_t block) const { return static_cast<Index>(std::min(n_vertices_, (block + 1) * length_)); }
  /// Whether a face has all its corners in one block.
  bool is_in_one(const Triangle& face) const {
    const std::size_t block = face[0] / length_;
    return face[1] / length_ == block && face[2] / length_ == block;
  }

 private:
  std::size_t n_vertices_;
  std::size_t length_;
};

}  // namespace whittle::polishing
