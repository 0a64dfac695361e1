#pragma once

#include <array>
#include <atomic>
#include <span>
#include <vector>

#include "complex/spoke_lists.hh"
#include "whittle/core/detail/select.hh"
#include "whittle/core/frame.hh"
#include "whittle/engine/formula/pair_minimum.hh"
#include "whittle/engine/formula/point_quadric.hh"
#include "whittle/engine/formula/quadric_term.hh"
#include "whittle/engine/threshold_pairs.hh"

namespace whittle {

/// Faces at a vertex, each by its two other corners.
class Wings {
 public:
  struct Wing {
    Index x, y;
  };

  Wings() = default;
  /// Each two neighbours in `fan` are those of a face.
  static Wings of_fan(std::span<const Spoke> fan) { return {fan, 1, fan.empty() ? 0 : fan.size() - 1}; }
  /// The first two of `pairs` are those of a face, then the next two, and so on.
  static Wings of_pairs(std::span<const Spoke> pairs) { return {pairs, 2, pairs.size() / 2}; }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Wing operator[](std::size_t i) const { return {spokes_[i * stride_].vertex, spokes_[i * stride_ + 1].vertex}; }
  std::span<const Spoke> spokes() const { return spokes_; }
  std::span<const Spoke> spokes_of(std::size_t i) const { return spokes_.subspan(i * stride_, 2); }

 private:
  Wings(std::span<const Spoke> spokes, std::size_t stride, std::size_t size)
      : spokes_(spokes), stride_(stride), size_(size) {}

  std::span<const Spoke> spokes_;
  std::size_t stride_ = 1;
  std::size_t size_ = 0;
};

/// The two stars of a pair (a, b), as far as a contraction looks at them. Valid until the next contraction.
struct PairStar {
  /// A common neighbour.
  struct Opposite {
    Index vertex;
    std::array<Index, 2> edges;  ///< from the pair's vertices to it, or what has been merged into those
  };
  Wings first;                      ///< faces at a without b
  Wings second;                     ///< faces at b without a
  std::vector<Opposite> opposites;  ///< of each face at a and b, the corner that is neither

  /// What a contraction does to the neighbourhood where the link condition doesn't hold. The merged vertex is called a.
  struct Joint {
    std::vector<Opposite> common;            ///< all common neighbours, ascending
    std::vector<std::vector<Spoke>> faces;   ///< at each of those afterwards, in pairs
    std::array<std::vector<Spoke>, 2> left;  ///< faces at a and at b that don't vanish, in pairs
    std::vector<Wings::Wing> coincident;     ///< of the faces that vanish as they would coincide, the other corners
    std::vector<Index> lost_edges;           ///< which lose all their faces
  };
  bool is_joint = false;  ///< If so, `first` and `second` are without the faces that vanish.
  Joint joint;
};

/// Two vertices that may become one: joined by an edge, or closer than a threshold.
struct Pair {
  Index id;
  Index a, b;
};

/// How a vertex lies in the surface. An edge is regular when it has exactly two faces.
enum class VertexOrder : std::uint8_t {
  regular,   ///< one closed fan of faces
  line,      ///< one open fan: an inner vertex of a border (or, in general, of a line of irregular edges)
  junction,  ///< anything else: bow-ties, meeting lines
};

/// What half-edges can't hold.
struct NonmanifoldCounts {
  std::uint64_t edges = 0;     ///< with three faces or more
  std::uint64_t vertices = 0;  ///< whose faces, connected over edges at it, are two sets or more
};

/// Any set of triangles under contraction: flat arrays, each vertex with its quadric and a list of its neighbours,
/// merged vertices and edges as forests. docs/dev/engine.md says what lies where, and why.
///
/// A regular vertex whose faces have one orientation has its neighbours in a ring, counter-clockwise: each two that
/// follow each other, the last and the first too, are those of a face. Any other has them in pairs, two for a face, in
/// the order (vertex, first, second) of the face.
///
/// Vertices are numbered along a space-filling curve, so that neighbours lie close in memory; `origin` gives the number
/// in the input. A contraction changes the lists of its own two vertices only: the others' name merged vertices, and
/// faces that have vanished, until they are next gathered. A face has vanished when two of its corners are one.
class TriangleComplex {
 public:
  /// The ends of a pair.
  struct Ends {
    Index first, second;
  };

  /// Takes the faces' vertex numbers as checked. Faces with two equal corners are left out.
  /// \param positions in model units; all in here is in the frame.
  /// \param threshold_pairs vertices that are pairs beside the edges; each has a face, none of them a common one
  /// \param quadric what the vertices' quadrics are made of, each summed in the input's order of faces
  /// \param threads 0 = all cores; the result is the same.
  TriangleComplex(std::span<const Vec3> positions, std::span<const Triangle> faces,
                  std::span<const VertexPair> threshold_pairs, const Frame& frame, const QuadricOptions& quadric,
                  unsigned threads);

  std::size_t n_vertex_slots() const { return vertices_.size(); }
  std::uint64_t n_vertices() const { return n_vertices_; }  ///< with at least one face
  std::uint64_t n_faces() const { return n_faces_; }
  std::uint64_t n_degenerate_faces() const { return n_degenerate_faces_; }  ///< left out at the start

  const Vec3& position(Index v) const { return vertices_[v].position; }
  PlacedQuadric placed(Index v) const {
    const StoredQuadric& q = quadrics_[v];
    return {vertices_[v].position, {q.a, q.slope == invalid_index ? Vec3::Zero() : slopes_[q.slope], q.c}};
  }
  /// Whether v lies where its quadric is least, as most do: then its slope is zero.
  bool is_level(Index v) const { return quadrics_[v].slope == invalid_index; }
  /// Level vertices side by side. \param vertex gives that of a lane
  template <class Real, class VertexAt>
  [[gnu::always_inline]] QuadricLanes<Real> placed_level(const VertexAt& vertex) const {
    const auto quadric = [&](std::size_t lane) -> const StoredQuadric& { return quadrics_[vertex(lane)]; };
    const auto point = point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return position(vertex(lane)); });
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
  /// With the point quadrics that joining holds v by; only where there are threshold pairs.
  PlacedQuadric placed_with_points(Index v) const { return with_points(placed(v), points_[v], point_weight_); }
  /// Level vertices with their points side by side.
  template <class Real, class VertexAt>
  [[gnu::always_inline]] QuadricLanes<Real> placed_level_with_points(const VertexAt& vertex) const {
    const auto points_at = [&](std::size_t lane) -> const PointQuadric& { return points_[vertex(lane)]; };
    PointQuadricLanes<Real> points{};
    points.center = point_lanes<Real>([&](std::size_t lane) -> const Vec3& { return points_at(lane).center; });
    fill_lanes(points.weight, [&](std::size_t lane) { return points_at(lane).weight; });
    fill_lanes(points.spread, [&](std::size_t lane) { return points_at(lane).spread; });
    QuadricLanes<Real> lanes = placed_level<Real>(vertex);
    add_points(lanes, points, point_weight_);
    return lanes;
  }
  Index origin(Index v) const { return vertices_[v].origin; }
  VertexOrder order(Index v) const { return stars_[v].order; }
  /// Whether its faces are one fan, closed or open.
  bool is_manifold(Index v) const { return order(v) != VertexOrder::junction; }
  /// Whether its neighbours are a ring.
  bool is_ring(Index v) const { return stars_[v].is_ring; }
  /// Whether v was ever in a face.
  bool has_faces(Index v) const { return stars_[v].spokes.size > 0; }
  /// The neighbours of v as last gathered, those of an irregular vertex as often as it has faces with them.
  std::span<const Spoke> neighbours(Index v) const { return spoke_lists_.of(stars_[v].spokes); }

  /// The number of edges at v. \pre its list is tidy
  int valence(Index v) const;

  /// The vertex that v has been merged into, v itself if none. Shortens the path. Several threads may ask at once: what
  /// they write is the same.
  Index representative(Index v) {
    const Index p = parent(v);
    const Index grandparent = parent(p);
    if (grandparent == p) return p;
    const Index r = root(grandparent);
    std::atomic_ref(parents_[v]).store(r, std::memory_order_relaxed);
    return r;
  }

  /// The edges are numbered along their lower vertices; after them come the threshold pairs. Where a contraction makes
  /// one of two edges, one of them lives on.
  std::size_t n_pair_slots() const { return pairs_.size(); }
  bool is_threshold_pair(Index id) const { return id >= n_edges_; }
  bool has_threshold_pairs() const { return pairs_.size() > n_edges_; }
  std::size_t n_edges() const { return n_edges_; }  ///< at first, as all numbers here
  bool is_pair_alive(Index id) const { return (pair_alive_[id / 64] >> (id % 64) & 1) != 0; }
  void remove_pair(Index id) { pair_alive_[id / 64] &= ~(std::uint64_t{1} << (id % 64)); }
  /// The vertices that the ends of a pair have been merged into; they may be the same for a threshold pair. Of a pair
  /// that isn't alive, any vertices: whether it is can't be foretold, and there is no branch on it.
  Ends ends(Index id) {
    const auto [first, second] = pairs_[id];
    return {representative(select(is_pair_alive(id), first, Index{0})), representative(second)};
  }
  /// Whether the ends of a pair that is alive are still two vertices with faces.
  bool is_contractible(const Pair& pair) const {
    return !is_threshold_pair(pair.id) || (pair.a != pair.b && has_faces(pair.a) && has_faces(pair.b));
  }
  /// The faces at v in pairs, with what has become of their corners. Valid until the next call, or plan.
  std::span<const Spoke> live_pairs(Index v);
  bool have_common_face(Index a, Index b);
  /// Before the first contraction; several threads may ask.
  Ends initial_ends(Index id) const { return pairs_[id]; }

  /// The edge that an edge has become by merging.
  Index live_edge(Index e) const;
  /// Makes v's list name vertices and edges as they are now.
  void tidy(Index v);

  void gather(Index a, Index b, PairStar& star);
  /// Looks at what contracting (a, b) would make of the topology: fills in the rest of `star`.
  ///
  /// Faces at a and at b over the same edge would coincide. Of those with one orientation as often as with the other
  /// none is left, else one of the more frequent one, at a if there is one.
  void plan_joint(Index a, Index b, PairStar& star);
  /// Whether a contraction planned as a joint makes no more border edges, non-manifold edges and non-manifold vertices,
  /// and leaves all neighbours of the two neighbours of the merged vertex, or of a neighbour of it: so no part falls
  /// apart or vanishes.
  bool is_no_less_manifold(Index a, Index b, const PairStar& star);

  /// Whether contracting (a, b) leaves the topology as it is: Lk a ∩ Lk b = Lk ab, borders and non-manifold lines seen
  /// as joined to a cone vertex. \cite dey_1999_topology
  bool link_condition(Index a, Index b, const PairStar& star) {
    return obviously_keeps_topology(a, b, star) || link_condition_of_any(a, b, star);
  }

  /// Merges `removed` into `survivor`, which becomes `merged`. `star` as gathered for (survivor, removed), `pair` the
  /// number of theirs.
  void contract(Index pair, Index survivor, Index removed, const PlacedQuadric& merged, const PairStar& star);

  /// Adds what planes through v have become to its quadric, before the contraction that moves them.
  void change_planes(Index v, const SymmetricMatrix& change) {
    quadrics_[v].a += change;
    quadrics_[v].last_change = n_contractions_ + 1;
  }

  Index n_contractions() const { return n_contractions_; }
  /// The number of contractions done when v last changed.
  Index last_change(Index v) const { return quadrics_[v].last_change; }

  /// Faces that vanished because they coincided with others.
  std::uint64_t n_coincident_faces() const { return n_coincident_faces_; }
  /// The faces there are, each from its lowest vertex on, ascending.
  std::vector<Triangle> live_faces();
  NonmanifoldCounts count_nonmanifold();

  void prefetch_pair(Index id) const { prefetch(&pairs_[id]); }
  void prefetch_ends(Index id) const {
    prefetch(parents_.data() + pairs_[id].first);
    prefetch(parents_.data() + pairs_[id].second);
  }
  void prefetch_placed(Index v) const {
    prefetch(&vertices_[v]);
    prefetch(&quadrics_[v]);
  }
  void prefetch_star(Index v) const { prefetch(&stars_[v]); }
  void prefetch_spokes(Index v) const { spoke_lists_.prefetch(stars_[v].spokes); }
  void prefetch_neighbours(Index v) const {  // where they have been merged once at most, as most have
    for (const Spoke& spoke : neighbours(v)) prefetch(&vertices_[parents_[spoke.vertex]]);
  }
  void prefetch_neighbours_quadrics(Index v) const {
    for (const Spoke& spoke : neighbours(v)) prefetch(&quadrics_[parents_[spoke.vertex]]);
  }

 private:
  Index parent(Index v) { return std::atomic_ref(parents_[v]).load(std::memory_order_relaxed); }
  Index root(Index v);
  void number_vertices(std::span<const Vec3> positions, const Frame& frame, std::vector<Index>& number_of,
                       unsigned threads);
  void list_faces(std::span<const Triangle> faces, const std::vector<Index>& number_of);
  void set_up_stars(const QuadricOptions& options, unsigned threads);
  void set_points(std::size_t begin, std::size_t end, const QuadricOptions& options);
  void sum_planes(std::size_t begin, std::size_t end, const QuadricOptions& options);
  void sum_planes_of_four(std::size_t begin, std::size_t end, const QuadricOptions& options);
  template <class Real>
  void sum_planes_in_lanes(std::size_t begin, std::size_t end, const QuadricOptions& options);
  template <class Real>
  void sum_planes_in_lanes(Index first, const QuadricOptions& options);
  SymmetricMatrix with_border_planes(SymmetricMatrix sum, Index v, const QuadricOptions& options);
  void make_pairs(Index v);
  void number_edges(unsigned threads);
  std::size_t sort_edges(Index v, std::size_t first, std::size_t end);
  Index find_edge(const Ends& edge, Index begin, Index end) const;
  void add_threshold_pairs(std::span<const VertexPair> pairs, const std::vector<Index>& number_of);

  Index place_in_link(Index v);
  void gather_link(std::span<const Wings::Wing> faces);
  VertexOrder order_of_link() const;
  void gather_link_of(std::span<const Spoke> pairs);
  std::size_t n_fans();
  bool is_link_oriented() const;
  Index step_along_link(Index& place) const;
  /// One of the two stars of a pair under look.
  struct GatheredStar {
    std::vector<Spoke> spokes;
    std::vector<Spoke> opposites;  ///< of the faces with the other vertex, the third corners
  };
  /// Where a surface isn't a closed manifold.
  struct Defects {
    struct Edge {
      Index low, high;
      std::size_t n_faces;
      auto operator<=>(const Edge&) const = default;
    };
    std::vector<Edge> edges;     ///< those of not two faces; some twice
    std::size_t n_vertices = 0;  ///< of several fans

    std::array<std::size_t, 3> counts();
  };
  Wings gather_one(Index v, Index other, GatheredStar& star);
  Wings gather_ring(Index v, Index other, GatheredStar& star);
  Wings gather_pairs(Index v, Index other, GatheredStar& star);
  bool link_condition_of_any(Index a, Index b, const PairStar& star);
  bool obviously_keeps_topology(Index a, Index b, const PairStar& star) const;
  void merge_edges(const PairStar::Opposite& opposite);
  Index store_slope(const Vec3& slope, Index v);
  void merge_stars(Index survivor, Index removed, const PairStar& star);
  static std::size_t n_merged(const PairStar& star, bool is_ring);
  static void join(const PairStar& star, bool is_ring, std::span<Spoke> spokes);
  void merge_points(Index pair, Index survivor, Index removed);
  void join_neighbourhoods(Index survivor, Index removed, const PairStar& star);
  void set_star(Index v, std::span<const Spoke> pairs);
  void plan_neighbour(Index v, Index a, Index b, PairStar::Joint& joint);
  void add_defects(Index v, std::span<const Spoke> pairs, Defects& defects);

  /// One cache line. The slope b, three more numbers, is zero but for the few vertices that are not where their quadric
  /// is least.
  struct alignas(64) StoredQuadric {
    SymmetricMatrix a;
    double c;
    Index slope;  ///< its number among `slopes_`, or `invalid_index`
    Index last_change;
  };
  struct Star {
    SpokeLists::List spokes;
    VertexOrder order = VertexOrder::regular;
    bool is_ring = true;
  };
  /// What is asked of a neighbour, and no more: two vertices a cache line.
  struct alignas(32) Vertex {
    Vec3 position;
    Index origin;
  };
  LargeArray<Vertex> vertices_;
  std::vector<Index> parents_;  ///< towards the vertex it was merged into; itself if none
  LargeArray<StoredQuadric> quadrics_;
  LargeArray<Vec3> slopes_;
  LargeArray<Star> stars_;
  SpokeLists spoke_lists_;
  LargeArray<Ends> pairs_;                 ///< the ends it had at first; `first` of one merged into another: that
  std::vector<std::uint64_t> pair_alive_;  ///< a bit a pair
  std::size_t n_edges_ = 0;
  std::vector<PointQuadric> points_;  ///< by vertex, if there are threshold pairs
  double point_weight_ = 0;
  std::uint64_t n_vertices_ = 0;
  std::uint64_t n_faces_ = 0;
  std::uint64_t n_degenerate_faces_ = 0;
  std::uint64_t n_coincident_faces_ = 0;
  std::vector<Index> irregular_;  ///< vertices, or what merged into one, that are or were irregular
  Index n_contractions_ = 0;

  /// A neighbour of one vertex or of a pair, with the number of faces at its edges to them.
  struct LinkEntry {
    Index vertex;
    std::array<Index, 2> n_faces{};                           ///< at the edge to the first and the second vertex
    std::array<Index, 2> next{invalid_index, invalid_index};  ///< places of up to two neighbours in the link
    Index n_ahead = 0;            ///< of how many faces (vertex, this, ...) it is the first other corner
    Index ahead = invalid_index;  ///< place of the second other one of the last of them
    bool opposite = false;        ///< corner of a face of the pair

    /// The place a walk along the link goes to from here.
    Index beyond(Index previous) const { return next[0] == previous ? next[1] : next[0]; }
  };
  /// Scratch: the neighbours under look, and each vertex's place among them, right only if the entry there names it.
  std::vector<LinkEntry> link_;
  std::vector<Index> link_place_;
  std::array<GatheredStar, 2> gathered_;  ///< scratch
  std::vector<Wings::Wing> faces_;        ///< scratch: those at one vertex, each by its other corners
  std::vector<Spoke> live_;               ///< scratch: the same, in pairs
};

}  // namespace whittle
