#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/detail/progress_meter.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/geometry/eight_floats.hh"

namespace whittle {

using IndexPairs = std::vector<std::array<Index, 2>>;

namespace detail {

/// A tree of boxes: eight successive boxes lie in one box of the next level.
class OverlapTree {
 public:
  /// \param boxes at least one \throw Cancelled
  OverlapTree(std::span<const FloatBox> boxes, const Workers& workers);

  std::size_t n_octets() const { return levels_.front().size(); }

  /// Appends the overlapping pairs of an octet's boxes with each other, and with later boxes.
  void find(std::size_t octet, IndexPairs& pairs) const;

 private:
  struct Search;
  static constexpr std::size_t fan_out = 8;

  /// Eight boxes side by side.
  struct alignas(32) Octet {
    Octet();
    void set(std::size_t lane, const FloatBox& box);

    std::array<EightFloats, 3> low, high;
  };

  /// \return the box around each octet
  std::vector<FloatBox> add_level(std::span<const FloatBox> below, const Workers& workers);

  std::vector<std::vector<Octet>> levels_;  ///< the lowest one first
};

}  // namespace detail

/// All pairs i < j of boxes with a common point for which `keep(i, j)` holds, always in the same order. Fast if
/// successive boxes are near each other.
/// \param keep called from several threads
/// \throw Cancelled
template <class Keep>
IndexPairs overlapping_boxes(std::span<const FloatBox> boxes, const Keep& keep, const detail::Workers& workers) {
  if (boxes.empty()) return {};
  const detail::OverlapTree tree(boxes, workers);
  constexpr std::size_t length = 64;
  std::vector<IndexPairs> found((tree.n_octets() + length - 1) / length);
  for_each_block(found.size(), workers, [&](std::size_t block) {
    IndexPairs near;
    const std::size_t end = std::min(tree.n_octets(), (block + 1) * length);
    for (std::size_t octet = block * length; octet < end; ++octet) {
      near.clear();
      tree.find(octet, near);
      for (const auto& pair : near) {
        if (keep(pair[0], pair[1])) found[block].push_back(pair);
      }
    }
  });
  std::vector<std::size_t> places{0};
  for (const IndexPairs& part : found) places.push_back(places.back() + part.size());
  IndexPairs all(places.back());
  for_each_block(found.size(), workers, [&](std::size_t block) {
    std::copy(found[block].begin(), found[block].end(), all.begin() + static_cast<std::ptrdiff_t>(places[block]));
  });
  return all;
}

}  // namespace whittle
