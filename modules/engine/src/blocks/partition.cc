#include "blocks/partition.hh"

#include <algorithm>
#include <atomic>
#include <utility>

#include "whittle/core/detail/parallel.hh"

namespace whittle {
namespace {

constexpr std::size_t samples_per_block = 256;
constexpr unsigned most_cuts = 16;  ///< one after the other: blocks are numbered in 16 bits

/// A complete binary tree of cuts; node n has the children 2n and 2n + 1.
class CutTree {
 public:
  CutTree(std::vector<Vec3> sample, unsigned depth, double first_share) : depth_(depth) {
    cuts_.resize(std::size_t{1} << depth);
    cut(sample, 1, first_share);
  }

  std::size_t n_cells() const { return cuts_.size(); }
  Partition::Block cell_of(const Vec3& p) const {
    std::size_t node = 1;
    for (unsigned level = 0; level < depth_; ++level) {
      const Cut& cut = cuts_[node];
      node = 2 * node + static_cast<std::size_t>(p[cut.axis] >= cut.at);
    }
    return static_cast<Partition::Block>(node - cuts_.size());
  }

 private:
  struct Cut {
    int axis = 0;
    double at = 0;
  };

  void cut(std::span<Vec3> sample, std::size_t node, double share) {
    if (node >= cuts_.size() || sample.empty()) return;
    const auto [low, high] = bounds_of(sample);
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const auto n_below = static_cast<std::ptrdiff_t>(static_cast<double>(sample.size()) * share);
    std::nth_element(sample.begin(), sample.begin() + n_below, sample.end(),
                     [axis](const Vec3& p, const Vec3& q) { return p[axis] < q[axis]; });
    cuts_[node] = {axis, sample[static_cast<std::size_t>(n_below)][axis]};
    cut(sample.first(static_cast<std::size_t>(n_below)), 2 * node, 0.5);
    cut(sample.subspan(static_cast<std::size_t>(n_below)), 2 * node + 1, 0.5);
  }

  unsigned depth_;
  std::vector<Cut> cuts_;
};

std::vector<Vec3> sample_of(const Surface& surface, std::size_t n_wanted) {
  const std::size_t step = std::max<std::size_t>(1, surface.positions.size() / n_wanted);
  std::vector<Vec3> sample;
  sample.reserve(surface.positions.size() / step + 1);
  for (std::size_t v = 0; v < surface.positions.size(); v += step) {
    sample.push_back(surface.frame.to_frame(surface.positions[v]));
  }
  return sample;
}

/// Sorts numbers by block, ascending in each, in parallel: counts first, by range and block.
class BlockSort {
 public:
  BlockSort(std::size_t n, std::size_t n_blocks)
      : n_(n), n_blocks_(n_blocks), places_((n + range_length - 1) / range_length * n_blocks) {}

  std::size_t n_ranges() const { return places_.size() / n_blocks_; }
  std::size_t begin(std::size_t range) const { return range * range_length; }
  std::size_t end(std::size_t range) const { return std::min(n_, (range + 1) * range_length); }

  void count(std::size_t range, Partition::Block block) { ++places_[range * n_blocks_ + block]; }
  /// Turns counts into places. \return the begin of each block, and the end
  std::vector<Index> sum_up() {
    std::vector<Index> begins(n_blocks_ + 1);
    Index sum = 0;
    for (std::size_t block = 0; block < n_blocks_; ++block) {
      begins[block] = sum;
      for (std::size_t range = 0; range < n_ranges(); ++range) {
        sum += std::exchange(places_[range * n_blocks_ + block], sum);
      }
    }
    begins[n_blocks_] = sum;
    return begins;
  }
  Index next_place(std::size_t range, Partition::Block block) { return places_[range * n_blocks_ + block]++; }

 private:
  std::size_t n_;
  std::size_t n_blocks_;
  std::vector<Index> places_;
};

void sort_vertices(const Surface& surface, const CutTree& tree, unsigned threads, Partition& partition) {
  const std::size_t n = surface.positions.size();
  partition.block_of.resize(n);
  partition.ranks.resize(n);
  partition.vertices.resize(n);
  BlockSort sort(n, tree.n_cells());
  for_each_block(sort.n_ranges(), threads, [&](std::size_t range) {
    for (std::size_t v = sort.begin(range); v < sort.end(range); ++v) {
      partition.block_of[v] = tree.cell_of(surface.frame.to_frame(surface.positions[v]));
      sort.count(range, partition.block_of[v]);
    }
  });
  partition.vertex_begins = sort.sum_up();
  for_each_block(sort.n_ranges(), threads, [&](std::size_t range) {
    for (std::size_t v = sort.begin(range); v < sort.end(range); ++v) {
      const Partition::Block block = partition.block_of[v];
      const Index place = sort.next_place(range, block);
      partition.vertices[place] = static_cast<Index>(v);
      partition.ranks[v] = place - partition.vertex_begins[block];
    }
  });
}

void sort_faces(const Surface& surface, std::size_t n_blocks, unsigned threads, Partition& partition) {
  const std::size_t n = surface.faces.size();
  std::vector<Partition::Block> block_of_face(n);
  partition.is_shared.resize(surface.positions.size());
  partition.faces.resize(n);
  BlockSort sort(n, n_blocks);
  for_each_block(sort.n_ranges(), threads, [&](std::size_t range) {
    for (std::size_t f = sort.begin(range); f < sort.end(range); ++f) {
      const auto& [a, b, c] = surface.faces[f];
      const auto& block_of = partition.block_of;
      const Partition::Block block = std::min({block_of[a], block_of[b], block_of[c]});
      block_of_face[f] = block;
      sort.count(range, block);
      for (const Index v : {a, b, c}) {  // several threads may write the same
        if (block_of[v] != block) std::atomic_ref(partition.is_shared[v]).store(1, std::memory_order_relaxed);
      }
    }
  });
  partition.face_begins = sort.sum_up();
  for_each_block(sort.n_ranges(), threads, [&](std::size_t range) {
    for (std::size_t f = sort.begin(range); f < sort.end(range); ++f) {
      partition.faces[sort.next_place(range, block_of_face[f])] = static_cast<Index>(f);
    }
  });
}

}  // namespace

Partition make_partition(const Surface& surface, std::size_t faces_per_block, double first_share, unsigned threads) {
  constexpr double most = 1.42;  // about the square root of 2: the next depth halves the blocks
  const auto limit = static_cast<std::size_t>(most * static_cast<double>(faces_per_block));
  unsigned depth = 0;
  while (depth < most_cuts && surface.faces.size() >> depth > limit) ++depth;
  const CutTree tree(sample_of(surface, samples_per_block << depth), depth, first_share);
  Partition partition;
  sort_vertices(surface, tree, threads, partition);
  sort_faces(surface, tree.n_cells(), threads, partition);
  return partition;
}

}  // namespace whittle
