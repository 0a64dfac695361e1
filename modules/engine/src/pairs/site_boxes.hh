#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "whittle/core/detail/lanes.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle {

/// Writes those of begin and begin + 1 whose lane is set. \return the new end. The outcome is unpredictable, hence
/// branch-free.
template <class Mask>
WHITTLE_INLINE Index* write_set(const Mask& mask, Index begin, Index* end) {
  *end = begin;
  end -= mask[0];
  *end = begin + 1;
  return end - mask[1];
}

inline void set_lane(PointLanes<Double2>& points, std::size_t lane, const Vec3& p) {
  points.x[lane] = p.x();
  points.y[lane] = p.y();
  points.z[lane] = p.z();
}

/// A tree without sorting: each `fan_out` sites in succession on the curve have a box, each `fan_out` boxes a larger
/// one, and so on.
class SiteBoxes {
 public:
  /// A search ends when it has found more sites than this.
  static constexpr std::size_t limit = 256;
  static constexpr std::size_t fan_out = 8;
  using Sites = std::array<Index, limit + fan_out>;

  explicit SiteBoxes(std::span<const Vec3> points) {
    std::vector<Box> boxes(points.begin(), points.end());
    while (levels_.empty() || levels_.back().size() > 1) boxes = add_level(boxes);
  }

  /// The sites in a box. \return how many; more than the limit if they were not all looked for
  std::size_t find(const Box& box, Sites& sites) const {
    const PointLanes<double> low = point_lanes(box.min());
    const PointLanes<double> high = point_lanes(box.max());
    Sites others;
    // Found in a level, and in the one above it; at the end these are the sites.
    Index* found = levels_.size() % 2 == 0 ? sites.data() : others.data();
    Index* above = levels_.size() % 2 == 0 ? others.data() : sites.data();
    found[0] = 0;
    std::size_t n = 1;
    for (std::size_t level = levels_.size(); level-- > 0 && n <= limit;) {
      std::swap(found, above);
      Index* end = found;
      for (std::size_t i = 0; i < n && end <= found + limit; ++i) {
        Index below = above[i] * fan_out;
        for (const Boxes& boxes : levels_[level][above[i]]) {
          const auto meets = (boxes.low.x <= high.x) & (boxes.low.y <= high.y) & (boxes.low.z <= high.z) &
                             (boxes.high.x >= low.x) & (boxes.high.y >= low.y) & (boxes.high.z >= low.z);
          end = write_set(meets, below, end);
          below += 2;
        }
      }
      n = static_cast<std::size_t>(end - found);
    }
    return n;
  }

 private:
  struct Boxes {
    PointLanes<Double2> low, high;
  };
  using Node = std::array<Boxes, fan_out / 2>;

  /// \return the boxes of its nodes
  std::vector<Box> add_level(std::vector<Box>& boxes) {
    std::vector<Box> result((boxes.size() + fan_out - 1) / fan_out);
    boxes.resize(result.size() * fan_out);  // with empty ones
    std::vector<Node> nodes(result.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      result[i / fan_out].extend(boxes[i]);
      Boxes& two = nodes[i / fan_out][i % fan_out / 2];
      set_lane(two.low, i % 2, boxes[i].min());
      set_lane(two.high, i % 2, boxes[i].max());
    }
    levels_.push_back(std::move(nodes));
    return result;
  }

  std::vector<std::vector<Node>> levels_;  ///< first the level of the sites, last the one with a single node
};

}  // namespace whittle
