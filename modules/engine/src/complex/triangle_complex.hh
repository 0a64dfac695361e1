#pragma once

#include <algorithm>
#include <atomic>
#include <span>
#include <vector>

#include "complex/contraction_profile.hh"
#include "complex/link.hh"
#include "complex/neighbour_lists.hh"
#include "whittle/core/detail/bit_set.hh"
#include "whittle/core/detail/select.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {

/// What half-edges can't hold.
struct NonmanifoldCounts {
  std::uint64_t edges = 0;     ///< with three faces or more
  std::uint64_t vertices = 0;  ///< whose faces, connected over edges at it, are two sets or more
};

/// Any set of triangles under contraction: connectivity and positions, in flat arrays. Each vertex has a list of its
/// neighbours; merged vertices and edges are forests. docs/dev/engine.md says what lies where, and why.
///
/// A regular vertex whose faces have one orientation has its neighbours in a ring, counter-clockwise: two that follow
/// each other, the last and the first too, make a face with it. Any other has them in pairs, two for a face, in the
/// order (vertex, first, second) of the face.
///
///      ring of v: p q r s t        pairs of v: p q  q r  s t
///
///           q                           q
///         / | \ .                     / | \ .
///        p--v--r                     p--v--r
///         \ /\ |                       /|
///          t--s                       t-s
///
/// Vertices are numbered along a space-filling curve, so that neighbours lie close in memory; `origin` gives the number
/// in the input. A contraction changes the lists of its own two vertices only. Other lists name merged vertices, and
/// faces that have vanished, until they are next gathered or made compact. A face has vanished when two of its corners
/// are one vertex.
class TriangleComplex {
 public:
  /// The ends of a pair.
  struct Ends {
    Index first, second;
  };

  // Building
  // -----------------------------------------------------------------------------------------------------------

  /// Lists the faces at each vertex, in the input's order. Faces with two equal corners are left out.
  /// \param positions in model units; all in here is in the frame. \param faces their vertex numbers are valid
  /// \param threads 0 = all cores; the result is the same.
  TriangleComplex(std::span<const Vec3> positions, std::span<const Triangle> faces, const Frame& frame,
                  unsigned threads);

  /// A face at a vertex, as `neighbours` lists it until `connect` is called.
  static LinkEdge as_face(const Neighbour& listed) { return {listed.vertex, listed.edge}; }

  /// Turns the lists of faces into lists of neighbours, and numbers the edges.
  /// \param threshold_pairs pairs beside the edges; each vertex has a face, no two have a common one
  void connect(std::span<const VertexPair> threshold_pairs, unsigned threads);

  /// \param frozen by number in the input
  void freeze(std::span<const std::uint8_t> frozen);

  /// Puts v elsewhere. \pre `connect` has not been called
  void set_position(Index v, const Vec3& position) { vertices_[v].position = position; }

  // Vertices
  // -----------------------------------------------------------------------------------------------------------

  std::size_t n_vertex_slots() const { return vertices_.size(); }
  std::uint64_t n_vertices() const { return n_vertices_; }  ///< with at least one face
  std::uint64_t n_faces() const { return n_faces_; }
  std::uint64_t n_degenerate_faces() const { return n_degenerate_faces_; }  ///< left out at the start
  /// Faces that vanished because they coincided with others.
  std::uint64_t n_coincident_faces() const { return n_coincident_faces_; }

  const Vec3& position(Index v) const { return vertices_[v].position; }
  /// Its number in the input. Ties between pairs go by it.
  Index origin(Index v) const { return vertices_[v].origin; }
  /// The inverse of `origin`: the vertex of each number in the input.
  std::vector<Index> vertices_by_origin() const;
  /// The input vertex that v stands for: its origin, unless `follow_positions` was called.
  Index identity(Index v) const { return identities_.empty() ? origin(v) : identities_[v]; }
  VertexKind kind(Index v) const { return stars_[v].kind; }
  /// Whether its faces are one fan, closed or open.
  bool is_manifold(Index v) const { return kind(v) != VertexKind::junction; }
  /// Whether its neighbours are a ring.
  bool is_ring(Index v) const { return stars_[v].is_ring; }
  /// Whether the surface is a closed, oriented manifold.
  bool is_closed() const {
    return std::all_of(stars_.begin(), stars_.end(), [](const Star& star) { return star.is_ring; });
  }
  /// Whether v takes part in no contraction: it has faces that aren't here.
  bool is_frozen(Index v) const { return stars_[v].is_frozen; }
  bool has_frozen_vertices() const { return has_frozen_vertices_; }
  /// Whether v was ever in a face.
  bool has_faces(Index v) const { return stars_[v].list.size > 0; }
  /// The neighbours of v as last gathered, those of an irregular vertex as often as it has faces with them.
  std::span<const Neighbour> neighbours(Index v) const { return neighbour_lists_.of(stars_[v].list); }
  /// The number of edges at v. \pre its list is compact
  int valence(Index v) const;

  /// The vertex that v has been merged into, v itself if none. Shortens the path. Several threads may ask at once: they
  /// write the same values.
  Index representative(Index v) {
    const Index p = parent(v);
    const Index grandparent = parent(p);
    if (grandparent == p) return p;
    const Index r = root(grandparent);
    std::atomic_ref(parents_[v]).store(r, std::memory_order_relaxed);
    return r;
  }

  // Pairs
  // --------------------------------------------------------------------------------------------------------------

  /// Number of edges and threshold pairs of the input. Ids never change. Edges are numbered along their lower vertices;
  /// threshold pairs come after them. When a contraction makes one edge of two, one of the two ids lives on.
  std::size_t n_pair_slots() const { return pairs_.size(); }
  std::size_t n_edges() const { return n_edges_; }  ///< Number of edges of the input.
  bool is_threshold_pair(Index id) const { return id >= n_edges_; }
  bool has_threshold_pairs() const { return pairs_.size() > n_edges_; }
  bool is_pair_alive(Index id) const { return pair_alive_.test(id); }
  void remove_pair(Index id) { pair_alive_.reset(id); }
  /// The vertices that the ends of a pair have been merged into; they may be the same for a threshold pair. Any
  /// vertices for a pair that isn't alive: that is unpredictable, hence branch-free.
  Ends ends(Index id) {
    const auto [first, second] = pairs_[id];
    return {representative(select_branch_free(is_pair_alive(id), first, Index{0})), representative(second)};
  }
  /// Before the first contraction; several threads may ask.
  Ends initial_ends(Index id) const { return pairs_[id]; }
  /// Whether the ends of a pair that is alive are still two vertices with faces.
  bool is_contractible(const Pair& pair) const {
    return !is_threshold_pair(pair.id) || (pair.a != pair.b && has_faces(pair.a) && has_faces(pair.b));
  }
  /// The edge that an edge has become by merging.
  Index live_edge(Index e) const;

  // Stars
  // --------------------------------------------------------------------------------------------------------------

  /// The faces at v in pairs, with live corners. Valid until the next call.
  std::span<const Neighbour> live_pairs(Index v) {
    list_live_pairs(v, live_);
    return live_;
  }
  /// The same into a list of the caller's. Several threads may ask at once.
  void list_live_pairs(Index v, std::vector<Neighbour>& pairs);
  bool have_common_face(Index a, Index b);
  /// Makes v's list name vertices and edges as they are now.
  void compact(Index v);
  /// Scratch for a look at a link.
  Link& link() { return link_; }

  // Contracting
  // --------------------------------------------------------------------------------------------------------

  /// Fills in the pair's stars.
  void gather(const Pair& pair, ContractionProfile& profile);

  /// Merges both vertices of a gathered pair into one of them.
  /// \param change gets what was done, but for `touched`
  void contract(const ContractionProfile& profile, Index survivor, const Vec3& position, Change& change);

  /// From now on a merged vertex that lies at only one of the two stands for that one, whichever survives.
  void follow_positions();
  /// The identities of the merged vertex and of the other one, if the pair becomes one vertex at `position`.
  struct Identities {
    Index survivor, removed;
  };
  Identities identities_after(const Pair& pair, Index survivor, const Vec3& position) const;

  Index n_contractions() const { return n_contractions_; }
  /// The number of contractions after which v, or what a cost keeps about it, last changed.
  Index last_change(Index v) const { return vertices_[v].last_change; }
  /// Notes that a cost has changed what it keeps about v, in the contraction just done.
  void note_change(Index v) { vertices_[v].last_change = n_contractions_; }

  // What is there
  // ------------------------------------------------------------------------------------------------------

  /// The live faces, each from its lowest vertex on, ascending.
  std::vector<Triangle> live_faces();
  /// Frozen vertices, and edges between two of them, are not counted.
  /// \param with_edges_to_frozen whether edges with one frozen end are
  NonmanifoldCounts count_nonmanifold(bool with_edges_to_frozen = true);

  // Prefetching
  // --------------------------------------------------------------------------------------------------------

  void prefetch_pair(Index id) const { prefetch_line(&pairs_[id]); }
  void prefetch_ends(Index id) const {
    prefetch_line(parents_.data() + pairs_[id].first);
    prefetch_line(parents_.data() + pairs_[id].second);
  }
  void prefetch_vertex(Index v) const { prefetch_line(&vertices_[v]); }
  void prefetch_star(Index v) const { prefetch_line(&stars_[v]); }
  void prefetch_list(Index v) const { neighbour_lists_.prefetch(stars_[v].list); }
  /// Calls `use` with what each neighbour has been merged into, if that was once at most, as it mostly is.
  template <class Use>
  void for_each_likely_neighbour(Index v, const Use& use) const {
    for (const Neighbour& neighbour : neighbours(v)) use(parents_[neighbour.vertex]);
  }

 private:
  /// One of the two stars of a pair.
  struct GatheredStar {
    std::vector<Neighbour> neighbours;
    std::vector<Neighbour> opposites;  ///< third corners of the faces with the other vertex
  };
  struct Star {
    NeighbourLists::List list;
    VertexKind kind = VertexKind::regular;
    bool is_ring = true;
    bool is_frozen = false;
  };
  /// What is asked of a neighbour, and no more: two vertices a cache line.
  struct alignas(32) Vertex {
    Vec3 position;
    Index origin;
    Index last_change;
  };

  Index parent(Index v) { return std::atomic_ref(parents_[v]).load(std::memory_order_relaxed); }
  Index root(Index v);

  // triangle_complex_build.cc
  static Neighbour as_listed(const LinkEdge& face) { return {face.x, face.y}; }
  std::vector<Index> number_vertices(std::span<const Vec3> positions, const Frame& frame, unsigned threads);
  void list_faces(std::span<const Triangle> faces, const std::vector<Index>& number_of);
  void find_small_rings(std::size_t begin, std::size_t end);
  void connect_by_link(Index v);
  void make_pairs(Index v);
  void number_edges(unsigned threads);
  std::size_t sort_edges(Index v, std::size_t first, std::size_t end);
  Index find_edge(const Ends& edge, Index begin, Index end) const;
  void add_threshold_pairs(std::span<const VertexPair> pairs);

  // triangle_complex.cc
  StarFaces gather_one(Index v, Index other, GatheredStar& star);
  StarFaces gather_ring(Index v, Index other, GatheredStar& star);
  StarFaces gather_pairs(Index v, Index other, GatheredStar& star);
  void merge_edges(const ContractionProfile::Common& neighbour, Change& change);
  void merge_stars(Index survivor, Index removed, const StarFaces& kept, const StarFaces& added);
  void merge_nonmanifold(Index survivor, Index removed, const ContractionProfile::NonmanifoldPlan& nonmanifold);
  void set_star(Index v, std::span<const Neighbour> pairs);

  LargeArray<Vertex> vertices_;
  std::vector<Index> identities_;  ///< empty: the origins
  std::vector<Index> parents_;     ///< towards the vertex it was merged into; itself if none
  LargeArray<Star> stars_;
  NeighbourLists neighbour_lists_;
  LargeArray<Ends> pairs_;  ///< the ends in the input; `first` of a merged edge is the edge that lives on
  detail::BitSet pair_alive_;
  std::size_t n_edges_ = 0;
  std::uint64_t n_vertices_ = 0;
  std::uint64_t n_faces_ = 0;
  std::uint64_t n_degenerate_faces_ = 0;
  std::uint64_t n_coincident_faces_ = 0;
  Index n_contractions_ = 0;
  bool has_frozen_vertices_ = false;
  std::vector<Index> irregular_;  ///< vertices that are or were irregular, or what they merged into

  Link link_;                             ///< scratch
  std::array<GatheredStar, 2> gathered_;  ///< scratch
  std::vector<Neighbour> live_;           ///< scratch
};

}  // namespace whittle
