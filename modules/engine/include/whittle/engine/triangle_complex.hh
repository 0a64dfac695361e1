#pragma once

#include <array>
#include <atomic>
#include <span>
#include <vector>

#include "whittle/engine/frame.hh"
#include "whittle/engine/pair_minimum.hh"
#include "whittle/engine/quadric_term.hh"
#include "whittle/engine/select.hh"
#include "whittle/engine/spoke_lists.hh"

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
  /// Of a face at a and b, the corner that is neither.
  struct Opposite {
    Index vertex;
    std::array<Index, 2> edges;  ///< from the pair's vertices to it, or what has been merged into those
  };
  Wings first;   ///< faces at a without b
  Wings second;  ///< faces at b without a
  std::vector<Opposite> opposites;
};

/// Two vertices that may become one, and the edge between them.
struct Pair {
  Index edge;
  Index a, b;
};

/// How a vertex lies in the surface. An edge is regular when it has exactly two faces.
enum class VertexOrder : std::uint8_t {
  regular,   ///< one closed fan of faces
  line,      ///< one open fan: an inner vertex of a border (or, in general, of a line of irregular edges)
  junction,  ///< anything else: bow-ties, meeting lines
};

/// Any set of triangles under contraction: flat arrays, each vertex with its quadric and a list of its neighbours,
/// merged vertices and edges as forests. docs/dev/engine.md says what lies where, and why.
///
/// A regular vertex has its neighbours in a ring, so that each two that follow each other, the last and the first too,
/// are those of a face. Any other has them in pairs, two for a face.
///
/// Vertices are numbered along a space-filling curve, so that neighbours lie close in memory; `origin` gives the number
/// in the input. A contraction changes the lists of its own two vertices only: the others' name merged vertices, and
/// faces that have vanished, until they are next gathered. A face has vanished when two of its corners are one.
class TriangleComplex {
 public:
  /// The ends of an edge.
  struct Edge {
    Index first, second;
  };

  /// Takes the faces' vertex numbers as checked. Faces with two equal corners are left out.
  /// \param positions in model units; all in here is in the frame.
  /// \param quadric what the vertices' quadrics are made of, each summed in the input's order of faces
  /// \param threads 0 = all cores; the result is the same.
  TriangleComplex(std::span<const Vec3> positions, std::span<const Triangle> faces, const Frame& frame,
                  const QuadricOptions& quadric, unsigned threads);

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
  Index origin(Index v) const { return vertices_[v].origin; }
  VertexOrder order(Index v) const { return stars_[v].order; }
  /// Whether v was ever in a face.
  bool has_faces(Index v) const { return stars_[v].spokes.size > 0; }
  /// The neighbours of v as last gathered, those of an irregular vertex as often as it has faces with them.
  std::span<const Spoke> neighbours(Index v) const { return spoke_lists_.of(stars_[v].spokes); }

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

  /// Edges are numbered along their lower vertices. Where a contraction makes one of two edges, one of them lives on.
  std::size_t n_edge_slots() const { return edges_.size(); }
  bool is_edge_alive(Index e) const { return (edge_alive_[e / 64] >> (e % 64) & 1) != 0; }
  /// The vertices that the ends of e have been merged into. Of an edge that isn't alive, any vertices: whether it is
  /// can't be foretold, and there is no branch on it.
  Edge ends(Index e) {
    const auto [first, second] = edges_[e];
    return {representative(select(is_edge_alive(e), first, Index{0})), representative(second)};
  }
  /// Before the first contraction; several threads may ask.
  Edge initial_ends(Index e) const { return edges_[e]; }

  void gather(Index a, Index b, PairStar& star);

  /// Whether contracting (a, b) leaves the topology as it is: Lk a ∩ Lk b = Lk ab, borders and non-manifold lines seen
  /// as joined to a cone vertex. \cite dey_1999_topology
  bool link_condition(Index a, Index b, const PairStar& star) {
    return obviously_keeps_topology(a, b, star) || link_condition_of_any(a, b, star);
  }

  /// Merges `removed` into `survivor`, which becomes `merged`. `star` as gathered for (survivor, removed), `edge` the
  /// one between them.
  void contract(Index edge, Index survivor, Index removed, const PlacedQuadric& merged, const PairStar& star);

  Index n_contractions() const { return n_contractions_; }
  /// The number of contractions done when v last changed.
  Index last_change(Index v) const { return quadrics_[v].last_change; }

  void prefetch_edge(Index e) const { prefetch(&edges_[e]); }
  void prefetch_ends(Index e) const {
    prefetch(parents_.data() + edges_[e].first);
    prefetch(parents_.data() + edges_[e].second);
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

 private:
  Index parent(Index v) { return std::atomic_ref(parents_[v]).load(std::memory_order_relaxed); }
  Index root(Index v);
  void number_vertices(std::span<const Vec3> positions, const Frame& frame, std::vector<Index>& number_of,
                       unsigned threads);
  void list_faces(std::span<const Triangle> faces, const std::vector<Index>& number_of);
  void set_up_stars(const QuadricOptions& options, unsigned threads);
  void sum_planes(std::size_t begin, std::size_t end, const QuadricOptions& options);
  void sum_planes_of_four(std::size_t begin, std::size_t end, const QuadricOptions& options);
  template <class Real>
  void sum_planes_in_lanes(std::size_t begin, std::size_t end, const QuadricOptions& options);
  template <class Real>
  void sum_planes_in_lanes(Index first, const QuadricOptions& options);
  SymmetricMatrix with_border_planes(SymmetricMatrix sum, Index v, const QuadricOptions& options);
  void make_ring(Index v);
  void make_pairs(Index v);
  void gather_link(Index v);
  VertexOrder order_of_link() const;
  void number_edges(unsigned threads);
  std::size_t sort_edges(Index v, std::size_t first, std::size_t end);
  Index find_edge(const Edge& edge, Index begin, Index end) const;

  Index place_in_link(Index v);
  bool is_ring(Index v) const { return stars_[v].order == VertexOrder::regular; }
  /// One of the two stars of a pair under look.
  struct GatheredStar {
    std::vector<Spoke> spokes;
    std::vector<Spoke> opposites;  ///< of the faces with the other vertex, the third corners
  };
  Wings gather_one(Index v, Index other, GatheredStar& star);
  Wings gather_ring(Index v, Index other, GatheredStar& star);
  Wings gather_pairs(Index v, Index other, GatheredStar& star);
  bool link_condition_of_any(Index a, Index b, const PairStar& star);
  bool obviously_keeps_topology(Index a, Index b, const PairStar& star) const;
  void remove_edge(Index e) { edge_alive_[e / 64] &= ~(std::uint64_t{1} << (e % 64)); }
  Index live_edge(Index e) const;
  void merge_edges(const PairStar::Opposite& opposite);
  Index store_slope(const Vec3& slope, Index v);
  void merge_stars(Index survivor, Index removed, const PairStar& star);
  static std::size_t n_merged(const PairStar& star, bool is_ring);
  static void join(const PairStar& star, bool is_ring, std::span<Spoke> spokes);

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
  LargeArray<Edge> edges_;                 ///< the ends it had at first; `first` of one merged into another: that
  std::vector<std::uint64_t> edge_alive_;  ///< a bit an edge
  std::uint64_t n_vertices_ = 0;
  std::uint64_t n_faces_ = 0;
  std::uint64_t n_degenerate_faces_ = 0;
  Index n_contractions_ = 0;

  /// A neighbour of one vertex or of a pair, with the number of faces at its edges to them.
  struct LinkEntry {
    Index vertex;
    std::array<Index, 2> n_faces{};                           ///< at the edge to the first and the second vertex
    std::array<Index, 2> next{invalid_index, invalid_index};  ///< places of up to two neighbours in the link
    bool opposite = false;                                    ///< corner of a face of the pair

    /// The place a walk along the link goes to from here.
    Index ahead(Index previous) const { return next[0] == previous ? next[1] : next[0]; }
  };
  /// Scratch: the neighbours under look, and each vertex's place among them, right only if the entry there names it.
  std::vector<LinkEntry> link_;
  std::vector<Index> link_place_;
  std::array<GatheredStar, 2> gathered_;  ///< scratch
};

}  // namespace whittle
