#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "pairs/site_tree.hh"
#include "pairs/vertex_sites.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/engine/part_gaps.hh"

// A vertex looks no further than the least distance that its part has found so far. It skips branches of the tree that
// lie in its own part, so vertices deep inside a part are done at once.

namespace whittle {
namespace {

constexpr std::size_t sites_per_leaf = 16;

/// Makes `least` no more than `value`.
void lower(std::atomic<double>& least, double value) {
  double seen = least.load(std::memory_order_relaxed);
  while (value < seen && !least.compare_exchange_weak(seen, value, std::memory_order_relaxed)) {
  }
}

/// The least distances squared from the parts, and the tree in which they are found.
class GapFinder {
 public:
  /// \param max_gap_sq in the frame
  GapFinder(const VertexSites& sites, const Parts& parts, double max_gap_sq)
      : sites_(sites), cloud_{sites.points}, tree_(3, cloud_, sites_per_leaf), gaps_sq_(parts.count) {
    for (auto& gap_sq : gaps_sq_) gap_sq = max_gap_sq;
    for (Index site = 0; site < sites.points.size(); ++site) add_site(site, parts);
    label(*tree_.root_node);
  }

  void look_around(Index site) {
    const Index part = part_of_site_[site];
    if (part == several) return;  // its gap is 0
    double reach_sq = gaps_sq_[part].load(std::memory_order_relaxed);
    look_into(*tree_.root_node, 0, Vec3::Zero(), site, reach_sq);
    lower(gaps_sq_[part], reach_sq);
  }

  double gap_sq(std::size_t part) const { return gaps_sq_[part]; }

 private:
  using Node = SiteTree::Node;
  static constexpr Index several = invalid_index;

  /// A node of the tree, numbered before those below it.
  struct Label {
    Index part;       ///< of all sites in it, or `several`
    std::size_t end;  ///< the number after those below it
  };

  void add_site(Index site, const Parts& parts) {
    const auto part_of = [&](Index member) { return parts.part_of[sites_.vertices[member]]; };
    Index common = part_of(sites_.begins[site]);
    for (Index member = sites_.begins[site]; member < sites_.begins[site + 1]; ++member) {
      if (part_of(member) != common) common = several;
    }
    part_of_site_.push_back(common);
    if (common != several) return;
    for (Index member = sites_.begins[site]; member < sites_.begins[site + 1]; ++member) gaps_sq_[part_of(member)] = 0;
  }

  Index label(const Node& node) {
    const std::size_t number = labels_.size();
    labels_.push_back({});
    Index part;
    if (node.child1 == nullptr) {
      part = part_of_site_[tree_.vAcc[node.node_type.lr.left]];
      for (std::size_t i = node.node_type.lr.left; i < node.node_type.lr.right; ++i) {
        if (part_of_site_[tree_.vAcc[i]] != part) part = several;
      }
    } else {
      const Index first = label(*node.child1);
      const Index second = label(*node.child2);
      part = first == second ? first : several;
    }
    labels_[number] = {part, labels_.size()};
    return part;
  }

  /// \param offset how far the site is from the node's box at least, along each axis
  /// \param reach_sq the least distance squared so far
  void look_into(const Node& node, std::size_t number, const Vec3& offset, Index site, double& reach_sq) {
    const Index part = part_of_site_[site];
    // No site in there is nearer, even with rounding: each term of its sum is at least as great.
    if (labels_[number].part == part || offset.squaredNorm() >= reach_sq) return;
    const Vec3& point = sites_.points[site];
    if (node.child1 == nullptr) {
      for (std::size_t i = node.node_type.lr.left; i < node.node_type.lr.right; ++i) {
        const Index other = tree_.vAcc[i];
        if (part_of_site_[other] != part) reach_sq = std::min(reach_sq, (point - sites_.points[other]).squaredNorm());
      }
      return;
    }
    const auto [axis, low, high] = node.node_type.sub;
    Vec3 to_first = offset;
    Vec3 to_second = offset;
    if (point[axis] > low) to_first[axis] = std::max(offset[axis], point[axis] - low);
    if (point[axis] < high) to_second[axis] = std::max(offset[axis], high - point[axis]);
    const std::size_t first = number + 1;
    const std::size_t second = labels_[first].end;
    if (to_first[axis] <= to_second[axis]) {
      look_into(*node.child1, first, to_first, site, reach_sq);
      look_into(*node.child2, second, to_second, site, reach_sq);
    } else {
      look_into(*node.child2, second, to_second, site, reach_sq);
      look_into(*node.child1, first, to_first, site, reach_sq);
    }
  }

  const VertexSites& sites_;
  SiteCloud cloud_;
  SiteTree tree_;
  std::vector<Index> part_of_site_;
  std::vector<Label> labels_;
  std::vector<std::atomic<double>> gaps_sq_;
};

}  // namespace

std::vector<double> gaps_between_parts(const IndexedMesh& mesh, const Parts& parts, const GapSearch& search) {
  if (!(search.max_gap >= 0)) {
    throw std::invalid_argument("gaps_between_parts: max_gap is negative or not a number");
  }
  std::vector<double> gaps(parts.count, std::numeric_limits<double>::infinity());
  if (parts.count < 2 || search.max_gap == 0) return gaps;
  const VertexSites sites = make_vertex_sites(mesh.positions, mesh.faces, search.threads);
  const double max_gap = search.max_gap * sites.frame.scale;
  // The square of a tiny gap may round to zero: use at least what tells coincident vertices from others.
  const double max_gap_sq = std::max(max_gap * max_gap, std::numeric_limits<double>::denorm_min());
  GapFinder finder(sites, parts, max_gap_sq);
  for_each_range(sites.points.size(), search.threads, [&](std::size_t begin, std::size_t end) {
    for (auto site = static_cast<Index>(begin); site < end; ++site) finder.look_around(site);
  });
  for (std::size_t part = 0; part < gaps.size(); ++part) {
    const double gap_sq = finder.gap_sq(part);
    if (gap_sq < max_gap_sq) gaps[part] = std::sqrt(gap_sq) * sites.frame.unscale;
  }
  return gaps;
}

}  // namespace whittle
