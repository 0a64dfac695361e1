#pragma once

#include <span>
#include <vector>

#include "cost/pair_cost.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/engine/formula/point_quadric.hh"
#include "whittle/engine/formula/quadric_term.hh"

namespace whittle {

/// The quadrics of a complex's vertices, each about its vertex.
class VertexQuadrics {
 public:
  /// Sums the planes of each vertex's faces, in the input's order. \pre the complex lists faces
  /// \param has_threshold_pairs then vertices have point quadrics, too
  VertexQuadrics(const TriangleComplex& complex, const QuadricOptions& options, bool has_threshold_pairs,
                 unsigned threads);

  /// Adds the planes through border edges, and takes what is known from before. \pre the complex is connected
  void start(const CostState& before);

  const SymmetricMatrix& matrix(Index v) const { return quadrics_[v].a; }
  /// Whether v lies where its quadric is least, as most do: then its slope is zero.
  bool is_level(Index v) const { return quadrics_[v].slope == invalid_index; }
  PlacedQuadric placed(Index v) const { return placed(v, complex_.position(v)); }
  /// \param position of v when its quadric was made
  PlacedQuadric placed(Index v, const Vec3& position) const {
    const Stored& q = quadrics_[v];
    // Number by number: copied in pairs and read in others, they would have to wait for memory.
    const SymmetricMatrix a{q.a.xx, q.a.xy, q.a.xz, q.a.yy, q.a.yz, q.a.zz};
    return {position, {a, q.slope == invalid_index ? Vec3::Zero() : slopes_[q.slope], q.c}};
  }
  /// With the point quadrics that hold v once it is joined; only if there are threshold pairs.
  PlacedQuadric with_points(Index v, const PlacedQuadric& placed) const {
    return whittle::with_points(placed, points_[v], options_.point_weight);
  }

  /// Level vertices side by side. \param vertex lane → vertex
  template <class Real, class VertexAt>
  WHITTLE_INLINE QuadricLanes<Real> placed_level(const VertexAt& vertex) const;
  /// Level vertices with their points side by side.
  template <class Real, class VertexAt>
  WHITTLE_INLINE QuadricLanes<Real> placed_level_with_points(const VertexAt& vertex) const;

  /// Stores the quadric of a merged vertex.
  void merge(const Change& change, const Quadric& quadric);
  /// Adds the change of planes through a neighbour of the merged vertex.
  void change_planes(Index v, const SymmetricMatrix& change) { quadrics_[v].a += change; }

  /// Where they lie.
  KeptOfVertices kept() const { return {reinterpret_cast<const std::byte*>(quadrics_.data()), sizeof(Stored)}; }

 private:
  /// One cache line. The slope b, three more numbers, is zero but for the few vertices that are not where their quadric
  /// is least.
  struct alignas(64) Stored {
    SymmetricMatrix a;
    double c;
    Index slope;  ///< its slot in `slopes_`, or `invalid_index`
  };

  void sum_range(std::size_t begin, std::size_t end);
  void sum_four_at_once(std::size_t begin, std::size_t end);
  template <class Real>
  void sum_range_in_lanes(std::size_t begin, std::size_t end);
  template <class Real>
  void sum_in_lanes(Index first);
  void set_points(std::size_t begin, std::size_t end);
  void add_borders();
  void store(Index v, const Quadric& quadric);
  void merge_points(const Change& change);

  const TriangleComplex& complex_;
  QuadricOptions options_;
  bool has_points_;
  LargeArray<Stored> quadrics_;
  LargeArray<Vec3> slopes_;
  std::vector<PointQuadric> points_;  ///< empty unless there are threshold pairs
};

template <class Real, class VertexAt>
WHITTLE_INLINE QuadricLanes<Real> VertexQuadrics::placed_level(const VertexAt& vertex) const {
  const auto quadric = [&](std::size_t lane) -> const Stored& { return quadrics_[vertex(lane)]; };
  const auto point =
      point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return complex_.position(vertex(lane)); });
  QuadricLanes<Real> lanes{};
  lanes.px = point.x;
  lanes.py = point.y;
  lanes.pz = point.z;
  fill_lanes(lanes.xx, [&](std::size_t lane) { return quadric(lane).a.xx; });
  fill_lanes(lanes.xy, [&](std::size_t lane) { return quadric(lane).a.xy; });
  fill_lanes(lanes.xz, [&](std::size_t lane) { return quadric(lane).a.xz; });
  fill_lanes(lanes.yy, [&](std::size_t lane) { return quadric(lane).a.yy; });
  fill_lanes(lanes.yz, [&](std::size_t lane) { return quadric(lane).a.yz; });
  fill_lanes(lanes.zz, [&](std::size_t lane) { return quadric(lane).a.zz; });
  fill_lanes(lanes.c, [&](std::size_t lane) { return quadric(lane).c; });
  return lanes;
}

template <class Real, class VertexAt>
WHITTLE_INLINE QuadricLanes<Real> VertexQuadrics::placed_level_with_points(const VertexAt& vertex) const {
  const auto points_at = [&](std::size_t lane) -> const PointQuadric& { return points_[vertex(lane)]; };
  PointQuadricLanes<Real> points{};
  points.center = point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return points_at(lane).center; });
  fill_lanes(points.weight, [&](std::size_t lane) { return points_at(lane).weight; });
  fill_lanes(points.spread, [&](std::size_t lane) { return points_at(lane).spread; });
  QuadricLanes<Real> lanes = placed_level<Real>(vertex);
  add_points(lanes, points, options_.point_weight);
  return lanes;
}

}  // namespace whittle
