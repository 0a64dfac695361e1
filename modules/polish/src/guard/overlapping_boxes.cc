#include "guard/overlapping_boxes.hh"

#include <algorithm>
#include <bit>
#include <limits>

#include "surface/eight_floats.hh"
#include "whittle/core/detail/lanes.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle::polishing {
namespace {

using Box = Eigen::AlignedBox3f;
using Pairs = std::vector<std::array<Index, 2>>;

constexpr std::size_t fan_out = 8;

/// Eight boxes side by side.
struct alignas(32) Octet {
  std::array<EightFloats, 3> low, high;

  Octet() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis].fill(std::numeric_limits<float>::infinity());
      high[axis].fill(-std::numeric_limits<float>::infinity());
    }
  }
  void set(std::size_t lane, const Box& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis][lane] = box.min()[Eigen::Index(axis)];
      high[axis][lane] = box.max()[Eigen::Index(axis)];
    }
  }
};

/// All ones in the lanes of those boxes of an octet that overlap one box of another octet.
WHITTLE_INLINE Int8 overlaps(const Octet& octet, const Octet& other, std::size_t lane) {
  Int8 all = ~Int8{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    all &= (load(octet.low[axis]) <= other.high[axis][lane]) & (load(octet.high[axis]) >= other.low[axis][lane]);
  }
  return all;
}

/// One bit for each lane.
WHITTLE_INLINE unsigned bits(const Int8& lanes) {
  Int8 x = lanes & Int8{1, 2, 4, 8, 16, 32, 64, 128};
  x |= shuffled<4, 5, 6, 7, 0, 1, 2, 3>(x, x);
  x |= shuffled<2, 3, 0, 1, 6, 7, 4, 5>(x, x);
  x |= shuffled<1, 0, 3, 2, 5, 4, 7, 6>(x, x);
  return static_cast<unsigned>(x[0]);
}

/// A tree of boxes: each eight successive ones lie in one box of the next level.
class BoxTree {
 public:
  BoxTree(std::span<const Box> boxes, std::span<const Triangle> faces, const detail::Workers& workers) : faces_(faces) {
    std::vector<Box> above = add_level(boxes, workers);
    while (levels_.back().size() > 1) above = add_level(above, workers);
  }

  std::size_t n_octets() const { return levels_.front().size(); }

  /// The pairs of an octet's boxes with each other, and with boxes further on.
  void find(std::size_t octet, Pairs& pairs) const {
    has_double4 ? find_in_wide_registers(octet, pairs) : find_in_octets(octet, pairs);
  }

 private:
  /// \return the boxes around each eight
  std::vector<Box> add_level(std::span<const Box> below, const detail::Workers& workers) {
    std::vector<Octet>& level = levels_.emplace_back((below.size() + fan_out - 1) / fan_out);
    std::vector<Box> above(level.size());
    for_each_range(level.size(), workers, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin * fan_out; i < std::min(end * fan_out, below.size()); ++i) {
        level[i / fan_out].set(i % fan_out, below[i]);
        above[i / fan_out].extend(below[i]);
      }
    });
    return above;
  }

  WHITTLE_AVX2 void find_in_wide_registers(std::size_t octet, Pairs& pairs) const { find_in_octets(octet, pairs); }

  WHITTLE_INLINE void find_in_octets(std::size_t octet, Pairs& pairs) const {
    struct Waiting {
      std::size_t octet, height;
    };
    std::array<Waiting, fan_out * most_levels> waiting;
    std::size_t n_waiting = 0;
    waiting[n_waiting++] = {0, levels_.size() - 1};
    while (n_waiting > 0) {
      const auto [number, height] = waiting[--n_waiting];
      if (height == 0) {
        write_pairs(octet, number, pairs);
        continue;
      }
      const Int8 overlapping = overlaps(levels_[height][number], levels_[1][octet / fan_out], octet % fan_out);
      for (unsigned found = bits(overlapping); found != 0; found &= found - 1) {
        const std::size_t below = fan_out * number + static_cast<std::size_t>(std::countr_zero(found));
        const bool is_before = ((below + 1) << (3 * (height - 1))) <= octet;  // all its octets are
        if (!is_before) waiting[n_waiting++] = {below, height - 1};
      }
    }
  }

  WHITTLE_INLINE void write_pairs(std::size_t octet, std::size_t other, Pairs& pairs) const {
    const bool is_one = levels_.size() == 1;
    const Int8 overlapping =
        is_one ? ~Int8{} : overlaps(levels_[0][octet], levels_[1][other / fan_out], other % fan_out);
    for (unsigned near = bits(overlapping); near != 0; near &= near - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(near));
      const std::size_t slot = fan_out * octet + lane;
      const unsigned seen = other == octet ? (2U << lane) - 1 : 0;  // pairs found from their other box
      for (unsigned found = bits(overlaps(levels_[0][other], levels_[0][octet], lane)) & ~seen; found != 0;
           found &= found - 1) {
        const std::size_t other_slot = fan_out * other + static_cast<std::size_t>(std::countr_zero(found));
        if (!faces_.empty() && n_common_corners(faces_[slot], faces_[other_slot]) != 0) continue;
        pairs.push_back({static_cast<Index>(slot), static_cast<Index>(other_slot)});
      }
    }
  }

  static constexpr std::size_t most_levels = 11;  // enough for 2^32 boxes

  std::span<const Triangle> faces_;         ///< of the boxes, or none
  std::vector<std::vector<Octet>> levels_;  ///< the lowest one first
};

}  // namespace

std::vector<std::array<Index, 2>> overlapping_boxes(std::span<const Box> boxes, std::span<const Triangle> faces,
                                                    const detail::Workers& workers) {
  if (boxes.empty()) return {};
  const BoxTree tree(boxes, faces, workers);
  constexpr std::size_t length = 64;
  std::vector<Pairs> found((tree.n_octets() + length - 1) / length);
  for_each_block(found.size(), workers, [&](std::size_t block) {
    const std::size_t end = std::min(tree.n_octets(), (block + 1) * length);
    for (std::size_t octet = block * length; octet < end; ++octet) tree.find(octet, found[block]);
  });
  std::vector<std::size_t> places{0};
  for (const Pairs& part : found) places.push_back(places.back() + part.size());
  Pairs all(places.back());
  for_each_block(found.size(), workers, [&](std::size_t block) {
    std::copy(found[block].begin(), found[block].end(), all.begin() + static_cast<std::ptrdiff_t>(places[block]));
  });
  return all;
}

}  // namespace whittle::polishing
