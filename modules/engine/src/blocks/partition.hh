#pragma once

#include <cstdint>
#include <vector>

#include "loop/working_surface.hh"
#include "whittle/core/detail/item_groups.hh"

namespace whittle {

/// A surface cut into blocks with about as many faces each. It depends on the surface alone.
///
/// Planes along the axes cut space into cells, a cell a block. A face belongs to the lowest block among those of its
/// corners. A vertex with a face in another block than its own is shared; all other vertices have all their faces in
/// their own block.
struct Partition {
  using Block = std::uint16_t;

  std::size_t n_blocks() const { return faces.size(); }

  std::vector<Block> block_of;          ///< per vertex
  std::vector<Index> ranks;             ///< per vertex, its place among those of its block
  std::vector<std::uint8_t> is_shared;  ///< per vertex
  detail::ItemGroups vertices;          ///< by block
  detail::ItemGroups faces;             ///< by block
};

/// \param faces_per_block blocks have up to 1.5 times as many, or down to 0.7 times, where density allows
/// \param first_share of the surface on the lower side of the first cut, and so on in turn: other shares give other
///        borders. (0, 1)
Partition make_partition(const WorkingSurface& surface, std::size_t faces_per_block, double first_share,
                         unsigned threads);

}  // namespace whittle
