#include "cost/quadric/vertex_quadrics.hh"

#include <algorithm>
#include <array>

#include "whittle/core/detail/lanes.hh"
#include "whittle/core/detail/parallel.hh"

namespace whittle {

/// The quadrics of a vertex a lane, each summed over its faces in their order.
template <class Real>
WHITTLE_INLINE void VertexQuadrics::sum_in_lanes(Index first) {
  constexpr std::size_t n = n_lanes<Real>;
  std::array<std::span<const Neighbour>, n> lists;
  std::size_t n_faces = 0;
  for (Index i = 0; i < n; ++i) {
    lists[i] = complex_.neighbours(first + i);
    n_faces = std::max(n_faces, lists[i].size());
  }
  const auto vertex = [&](std::size_t lane) { return first + static_cast<Index>(lane); };
  const auto position = [&](Index v) -> const Vec3& { return complex_.position(v); };
  const auto center = point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return position(vertex(lane)); });
  SymmetricLanes<Real> sum;
  for (std::size_t i = 0; i < n_faces; ++i) {
    const auto face = [&](std::size_t lane) {  // where there are no more, one without area
      return i < lists[lane].size() ? TriangleComplex::as_face(lists[lane][i]) : LinkEdge{vertex(lane), vertex(lane)};
    };
    sum += corner_quadrics(
        center, point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return position(face(lane).x); }),
        point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return position(face(lane).y); }), options_);
  }
  for (std::size_t i = 0; i < n; ++i) {
    quadrics_[vertex(i)] = {{lane_of(sum.xx, i), lane_of(sum.xy, i), lane_of(sum.xz, i), lane_of(sum.yy, i),
                             lane_of(sum.yz, i), lane_of(sum.zz, i)},
                            0,
                            invalid_index};
  }
}

template <class Real>
WHITTLE_INLINE void VertexQuadrics::sum_range_in_lanes(std::size_t begin, std::size_t end) {
  auto v = static_cast<Index>(begin);
  for (; v + n_lanes<Real> <= end; v += n_lanes<Real>) sum_in_lanes<Real>(v);
  for (; v < end; ++v) sum_in_lanes<double>(v);
}

WHITTLE_AVX2 void VertexQuadrics::sum_four_at_once(std::size_t begin, std::size_t end) {
  sum_range_in_lanes<Double4>(begin, end);
}

void VertexQuadrics::sum_range(std::size_t begin, std::size_t end) {
  if (has_double4) {
    sum_four_at_once(begin, end);
  } else {
    sum_range_in_lanes<Double2>(begin, end);
  }
}

VertexQuadrics::VertexQuadrics(const TriangleComplex& complex, const QuadricOptions& options, bool has_threshold_pairs,
                               unsigned threads)
    : complex_(complex), options_(options), has_points_(has_threshold_pairs) {
  const std::size_t n_vertices = complex_.n_vertex_slots();
  quadrics_.resize(n_vertices);
  if (has_points_) points_.resize(n_vertices);
  for_each_range(n_vertices, threads, [this](std::size_t begin, std::size_t end) {
    sum_range(begin, end);
    if (has_points_) set_points(begin, end);
  });
}

/// \pre the quadrics are those of the faces alone
void VertexQuadrics::set_points(std::size_t begin, std::size_t end) {
  const double share = 1 / (1 + 3 * options_.regularization);  // of a plane's weight in the trace of its quadric
  for (auto v = static_cast<Index>(begin); v < end; ++v) {
    points_[v] = {complex_.position(v), share * quadrics_[v].a.trace(), 0};
  }
}

/// Only vertices without a ring have border edges.
void VertexQuadrics::add_borders() {
  if (options_.boundary_weight == 0) return;
  const auto position = [this](Index v) -> const Vec3& { return complex_.position(v); };
  std::vector<Index> ends;  // of the edges at a vertex, one for each face there
  for (Index v = 0; v < complex_.n_vertex_slots(); ++v) {
    if (complex_.is_ring(v) || complex_.kind(v) == VertexKind::regular || complex_.is_frozen(v)) continue;
    const std::span<const Neighbour> pairs = complex_.neighbours(v);
    ends.clear();
    for (const Neighbour& neighbour : pairs) ends.push_back(neighbour.vertex);
    std::sort(ends.begin(), ends.end());
    const auto is_border = [&ends](Index w) {
      const auto [first, last] = std::equal_range(ends.begin(), ends.end(), w);
      return last - first == 1;
    };
    SymmetricMatrix& sum = quadrics_[v].a;
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
      const Index x = pairs[i].vertex;
      const Index y = pairs[i + 1].vertex;
      if (is_border(x)) sum += border_quadric(position(v), position(x), position(y), options_);
      if (is_border(y)) sum += border_quadric(position(y), position(v), position(x), options_);
    }
  }
}

void VertexQuadrics::start(const CostState& before) {
  for_each_quadric(before.seams, complex_, [this](Index v, Quadric quadric) {
    quadric.a += quadrics_[v].a;
    store(v, quadric);
  });
  add_borders();
  const auto take = [this](Index v, const Quadric& quadric) { store(v, quadric); };
  for_each_quadric(before.faces, complex_, take);
  for_each_quadric(before.quadrics, complex_, take);
}

void VertexQuadrics::merge(const Change& change, const Quadric& quadric) {
  store(change.survivor, quadric);
  if (has_points_) merge_points(change);
}

/// The slope goes to the slot of v's old one, if it had one.
void VertexQuadrics::store(Index v, const Quadric& quadric) {
  Stored& stored = quadrics_[v];
  stored.a = quadric.a;
  stored.c = quadric.c;
  if (quadric.b.isZero(0)) {
    stored.slope = invalid_index;
    return;
  }
  if (stored.slope == invalid_index) {
    stored.slope = static_cast<Index>(slopes_.size());
    slopes_.emplace_back();
  }
  slopes_[stored.slope] = quadric.b;
}

/// Points of vertices joined by a threshold pair are in their quadric from now on.
void VertexQuadrics::merge_points(const Change& change) {
  PointQuadric& merged = points_[change.survivor];
  if (complex_.is_threshold_pair(change.pair.id)) {
    merged = {};
  } else {
    merged = points_[change.pair.a] + points_[change.pair.b];
  }
}

}  // namespace whittle
