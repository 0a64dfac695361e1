#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "whittle/core/progress.hh"
#include "whittle/core/vertex_pair.hh"

// Vertex pairs that no edge joins but that lie close together: the other half of the valid pairs of Garland & Heckbert,
// 3.2. Contracting them joins parts that don't touch. \cite garland_1997_surface

namespace whittle {

struct PairSearch {
  double threshold = 0;  ///< Vertices nearer than this make a pair, model units. [0, inf]; 0 = none.

  /// At most so many of each vertex, the nearest: a pair stays if it is among those of either vertex. Empty = no limit.
  std::optional<std::uint32_t> max_pairs = 32;

  /// Whether pairs across the inside of a thin wall count: behind the surface at both ends, with normals (weighted by
  /// area) that face away from each other.
  bool across_walls = false;

  unsigned threads = 0;  ///< 0 = all cores. No result depends on it.

  ProgressCallback progress{};  ///< Called now and then; false cancels the search.
};

struct ThresholdPairs {
  std::vector<VertexPair> pairs;  ///< ascending
  bool capped = false;            ///< some vertex had more than `max_pairs`
};

/// All pairs of vertices whose distance is less than the threshold and that are not corners of one face.
///
/// Faces with two equal corners don't count, nor do vertices in no (other) face. Vertices at the same position are at
/// distance 0. Pairs of equal length at a vertex go by the number of the other vertex. The result depends neither on
/// the unit nor on where the mesh lies.
///
/// Each vertex is compared with those near it, or, where there are many, with about the nearest `max_pairs`. With that
/// limit memory is O(n · max_pairs).
/// \throw std::invalid_argument for a threshold that is negative or not a number, a `max_pairs` of 0, a vertex number
///        out of range or a coordinate that isn't finite. \throw Cancelled if `progress` returned false.
ThresholdPairs find_threshold_pairs(std::span<const Vec3> positions, std::span<const Triangle> faces,
                                    const PairSearch& search);

}  // namespace whittle
