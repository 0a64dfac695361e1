#pragma once

#include <limits>
#include <nanoflann.hpp>
#include <span>

#include "pairs/vertex_sites.hh"

namespace whittle {

/// What nanoflann asks for to build a tree over sites.
struct SiteCloud {
  std::span<const Vec3> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(Index site, std::size_t axis) const { return points[site][static_cast<Eigen::Index>(axis)]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Squared distances to the tree's planes, but not to its points. The result set is offered every point of the leaves
/// within reach, and measures by itself: with one formula everywhere, and branch-free, as the outcome is
/// unpredictable. This halves the time of a search.
struct LeafMetric {
  using ElementType = double;
  using DistanceType = double;

  explicit LeafMetric(const SiteCloud&) {}
  // NOLINTNEXTLINE(readability-identifier-naming): nanoflann's
  double evalMetric(const double*, Index, std::size_t) const { return 0; }
  double accum_dist(double a, double b, std::size_t) const { return (a - b) * (a - b); }
};

using SiteTree = nanoflann::KDTreeSingleIndexAdaptor<LeafMetric, SiteCloud, 3, Index>;

/// How far a tree has to look to miss no point at a squared distance below `reach_sq`. It sums the distances to its
/// planes, some thousands at most, with rounding.
inline double with_margin(double reach_sq) { return reach_sq * (1 + 1e-9) + std::numeric_limits<double>::min(); }

}  // namespace whittle
