#include "blocks/partition.hh"

#include <algorithm>
#include <atomic>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/box.hh"

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
    int axis = 0;
    bounds_of(sample).sizes().maxCoeff(&axis);
    const auto n_below = static_cast<std::ptrdiff_t>(static_cast<double>(sample.size()) * share);
    // A total order: where points are level, each standard library would choose others.
    std::nth_element(sample.begin(), sample.begin() + n_below, sample.end(), [axis](const Vec3& p, const Vec3& q) {
      for (const int i : {axis, (axis + 1) % 3, (axis + 2) % 3}) {
        if (p[i] != q[i]) return p[i] < q[i];
      }
      return false;
    });
    cuts_[node] = {axis, sample[static_cast<std::size_t>(n_below)][axis]};
    cut(sample.first(static_cast<std::size_t>(n_below)), 2 * node, 0.5);
    cut(sample.subspan(static_cast<std::size_t>(n_below)), 2 * node + 1, 0.5);
  }

  unsigned depth_;
  std::vector<Cut> cuts_;
};

std::vector<Vec3> sample_of(const WorkingSurface& surface, std::size_t n_wanted) {
  const std::size_t step = std::max<std::size_t>(1, surface.positions.size() / n_wanted);
  std::vector<Vec3> sample;
  sample.reserve(surface.positions.size() / step + 1);
  for (std::size_t v = 0; v < surface.positions.size(); v += step) {
    sample.push_back(surface.frame.to_frame(surface.positions[v]));
  }
  return sample;
}

void sort_vertices(const WorkingSurface& surface, const CutTree& tree, unsigned threads, Partition& partition) {
  const std::size_t n = surface.positions.size();
  partition.block_of.resize(n);
  partition.ranks.resize(n);
  for_each_range(n, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      partition.block_of[v] = tree.cell_of(surface.frame.to_frame(surface.positions[v]));
    }
  });
  partition.vertices =
      detail::ItemGroups(n, tree.n_cells(), threads, [&](Index v, const auto& use) { use(partition.block_of[v]); });
  for_each_block(tree.n_cells(), threads, [&](std::size_t block) {
    Index rank = 0;
    for (const Index v : partition.vertices.of(block)) partition.ranks[v] = rank++;
  });
}

void sort_faces(const WorkingSurface& surface, std::size_t n_blocks, unsigned threads, Partition& partition) {
  const std::vector<Partition::Block>& block_of = partition.block_of;
  const auto block_of_face = [&](const Triangle& face) {
    return std::min({block_of[face[0]], block_of[face[1]], block_of[face[2]]});
  };
  partition.is_shared.resize(surface.positions.size());
  for_each_range(surface.faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Partition::Block block = block_of_face(surface.faces[f]);
      for (const Index v : surface.faces[f]) {  // several threads may write the same
        if (block_of[v] != block) std::atomic_ref(partition.is_shared[v]).store(1, std::memory_order_relaxed);
      }
    }
  });
  partition.faces = detail::ItemGroups(surface.faces.size(), n_blocks, threads,
                                       [&](Index f, const auto& use) { use(block_of_face(surface.faces[f])); });
}

}  // namespace

Partition make_partition(const WorkingSurface& surface, std::size_t faces_per_block, double first_share,
                         unsigned threads) {
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
