#include "whittle/core/geometry/overlapping_boxes.hh"

#include <bit>
#include <limits>

namespace whittle::detail {
namespace {

/// One bit for each lane.
WHITTLE_INLINE unsigned bits(const Int8& lanes) {
  Int8 x = lanes & Int8{1, 2, 4, 8, 16, 32, 64, 128};
  x |= shuffled<4, 5, 6, 7, 0, 1, 2, 3>(x, x);
  x |= shuffled<2, 3, 0, 1, 6, 7, 4, 5>(x, x);
  x |= shuffled<1, 0, 3, 2, 5, 4, 7, 6>(x, x);
  return static_cast<unsigned>(x[0]);
}

}  // namespace

OverlapTree::Octet::Octet() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis].fill(std::numeric_limits<float>::infinity());
    high[axis].fill(-std::numeric_limits<float>::infinity());
  }
}

void OverlapTree::Octet::set(std::size_t lane, const FloatBox& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis][lane] = box.min()[Eigen::Index(axis)];
    high[axis][lane] = box.max()[Eigen::Index(axis)];
  }
}

OverlapTree::OverlapTree(std::span<const FloatBox> boxes, const Workers& workers) {
  std::vector<FloatBox> above = add_level(boxes, workers);
  while (levels_.back().size() > 1) above = add_level(above, workers);
}

std::vector<FloatBox> OverlapTree::add_level(std::span<const FloatBox> below, const Workers& workers) {
  std::vector<Octet>& level = levels_.emplace_back((below.size() + fan_out - 1) / fan_out);
  std::vector<FloatBox> above(level.size());
  for_each_range(level.size(), workers, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin * fan_out; i < std::min(end * fan_out, below.size()); ++i) {
      level[i / fan_out].set(i % fan_out, below[i]);
      above[i / fan_out].extend(below[i]);
    }
  });
  return above;
}

/// The search, written once for narrow and for wide registers.
struct OverlapTree::Search {
  /// All ones in the lanes of an octet's boxes that overlap one box of another octet.
  WHITTLE_INLINE static Int8 overlaps(const Octet& octet, const Octet& other, std::size_t lane) {
    Int8 all = ~Int8{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all &= (load(octet.low[axis]) <= other.high[axis][lane]) & (load(octet.high[axis]) >= other.low[axis][lane]);
    }
    return all;
  }

  WHITTLE_AVX2 static void in_wide_registers(const OverlapTree& tree, std::size_t octet, IndexPairs& pairs) {
    in_octets(tree, octet, pairs);
  }

  WHITTLE_INLINE static void in_octets(const OverlapTree& tree, std::size_t octet, IndexPairs& pairs) {
    struct Waiting {
      std::size_t octet, height;
    };
    constexpr std::size_t most_levels = 11;  // enough for 2^32 boxes
    const auto& levels = tree.levels_;
    std::array<Waiting, fan_out * most_levels> waiting;
    std::size_t n_waiting = 0;
    waiting[n_waiting++] = {0, levels.size() - 1};
    while (n_waiting > 0) {
      const auto [number, height] = waiting[--n_waiting];
      if (height == 0) {
        write_pairs(tree, octet, number, pairs);
        continue;
      }
      const Int8 overlapping = overlaps(levels[height][number], levels[1][octet / fan_out], octet % fan_out);
      for (unsigned found = bits(overlapping); found != 0; found &= found - 1) {
        const std::size_t below = fan_out * number + static_cast<std::size_t>(std::countr_zero(found));
        const bool is_before = ((below + 1) << (3 * (height - 1))) <= octet;  // all its octets are
        if (!is_before) waiting[n_waiting++] = {below, height - 1};
      }
    }
  }

  WHITTLE_INLINE static void write_pairs(const OverlapTree& tree, std::size_t octet, std::size_t other,
                                         IndexPairs& pairs) {
    const auto& levels = tree.levels_;
    const bool is_one = levels.size() == 1;
    const Int8 overlapping = is_one ? ~Int8{} : overlaps(levels[0][octet], levels[1][other / fan_out], other % fan_out);
    for (unsigned near = bits(overlapping); near != 0; near &= near - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(near));
      const auto slot = static_cast<Index>(fan_out * octet + lane);
      const unsigned seen = other == octet ? (2U << lane) - 1 : 0;  // pairs found from their other box
      for (unsigned found = bits(overlaps(levels[0][other], levels[0][octet], lane)) & ~seen; found != 0;
           found &= found - 1) {
        pairs.push_back(
            {slot, static_cast<Index>(fan_out * other + static_cast<std::size_t>(std::countr_zero(found)))});
      }
    }
  }
};

void OverlapTree::find(std::size_t octet, IndexPairs& pairs) const {
  has_double4 ? Search::in_wide_registers(*this, octet, pairs) : Search::in_octets(*this, octet, pairs);
}

}  // namespace whittle::detail
