#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "complex/contraction_profile.hh"

namespace whittle {

/// Puts the faces of a closed fan in its order, branch-free, because the order is unpredictable: each face names the
/// neighbour after it, which is looked up by the low bits of its number.
class FanSorter {
 public:
  static constexpr std::size_t max_faces = 12;

  /// Writes the neighbours in the fan's order to `ring`. False if the faces, up to `max_faces`, are not one closed fan,
  /// each neighbour once, all of one orientation; or if the low bits of two neighbours are the same.
  /// \param faces (v, vertex, edge), as `TriangleComplex` lists them
  bool sort(std::span<const Neighbour> faces, std::span<Index> ring) {
    const std::size_t n = faces.size();
    for (std::size_t i = 0; i < n; ++i) slot(faces[i].vertex) = static_cast<std::uint8_t>(i);
    bool is_ring = true;
    for (std::size_t i = 0; i < n; ++i) is_ring &= slot(faces[i].vertex) == i;
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Neighbour here = faces[at];
      ring[i] = here.vertex;
      at = std::min<std::size_t>(slot(here.edge), n - 1);
      is_ring &= faces[at].vertex == here.edge;
      is_ring &= (at == 0) == (i + 1 == n);
    }
    return is_ring;
  }

 private:
  std::uint8_t& slot(Index v) { return slots_[v % slots_.size()]; }

  std::array<std::uint8_t, 256> slots_{};  ///< right only if the face there begins with the vertex sought
};

}  // namespace whittle
