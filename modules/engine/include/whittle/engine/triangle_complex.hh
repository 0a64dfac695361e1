#pragma once

#include <span>
#include <vector>

#include "whittle/engine/indexed_mesh.hh"
#include "whittle/engine/prefetch.hh"

namespace whittle {

/// The faces at each vertex. Up to 15 lie in one cache line with their count; longer lists are rare and lie elsewhere.
class FaceLists {
 public:
  FaceLists() = default;
  explicit FaceLists(std::size_t n_vertices) : lists_(n_vertices) {}

  std::span<Index> of(Index v) {
    List& list = lists_[v];
    if (list.count <= inline_capacity) return {list.faces.data(), list.count};
    return overflow_[list.faces[0]];
  }
  std::span<const Index> of(Index v) const { return const_cast<FaceLists*>(this)->of(v); }

  void push_back(Index v, Index face) {
    List& list = lists_[v];
    if (list.count < inline_capacity) {
      list.faces[list.count++] = face;
    } else {
      push_back_to_overflow(list, face);
    }
  }
  /// Keeps the first `count` of v's faces.
  void truncate(Index v, std::size_t count) {
    List& list = lists_[v];
    if (list.count > inline_capacity) shrink_overflow(list, count);
    list.count = static_cast<Index>(count);
  }

  void prefetch(Index v) const { whittle::prefetch(&lists_[v]); }

 private:
  static constexpr Index inline_capacity = 15;
  struct alignas(64) List {
    Index count;
    std::array<Index, inline_capacity>
        faces;  ///< the faces; with more, faces[0] is the number of the list in `overflow_`
  };
  void push_back_to_overflow(List& list, Index face);
  void shrink_overflow(List& list, std::size_t count);

  std::vector<List> lists_;
  std::vector<std::vector<Index>> overflow_;
  std::vector<Index> free_overflow_;
};

/// The two stars of a pair (a, b), as far as a contraction looks at them.
struct PairStar {
  struct Wing {
    Index face;
    Index x, y;  ///< the other two corners, in the face's orientation
  };
  struct Shared {
    Index face;
    Index opposite;  ///< the corner that is neither a nor b
  };
  std::vector<Wing> first;     ///< faces at a without b
  std::vector<Wing> second;    ///< faces at b without a
  std::vector<Shared> shared;  ///< faces at a and b
};

/// How a vertex lies in the surface. An edge is regular when it has exactly two faces.
enum class VertexOrder : std::uint8_t {
  regular,   ///< one closed fan of faces
  line,      ///< one open fan: an inner vertex of a border (or, in general, of a line of irregular edges)
  junction,  ///< anything else: bow-ties, meeting lines
};

/// Any set of triangles under contraction: flat arrays, a face list per vertex, merged vertices as a forest.
///
/// Vertices and faces are numbered along a space-filling curve, so that neighbours lie close in memory; `origin` gives
/// the number in the input. Positions are in the frame handed in by the caller. Faces that a contraction removes are
/// dropped from the lists of their third corners when those are next looked at.
class TriangleComplex {
 public:
  /// The ends of an edge.
  struct Edge {
    Index first, second;
  };

  /// Takes the faces' vertex numbers as checked. Faces with two equal corners are left out.
  /// \param threads 0 = all cores; the result is the same.
  TriangleComplex(std::vector<Vec3> positions, std::span<const Triangle> faces, unsigned threads);

  std::size_t n_vertex_slots() const { return vertices_.size(); }
  std::size_t n_face_slots() const { return faces_.size(); }
  std::uint64_t n_vertices() const { return n_vertices_; }  ///< with at least one face
  std::uint64_t n_faces() const { return n_faces_; }
  std::uint64_t n_degenerate_faces() const { return n_degenerate_faces_; }  ///< left out at the start

  const Vec3& position(Index v) const { return vertices_[v].position; }
  Index origin(Index v) const { return vertices_[v].origin; }
  Index face_origin(Index f) const { return face_origins_[f]; }
  bool is_alive(Index f) const { return faces_[f].corners[0] != invalid_index; }
  const Triangle& face(Index f) const { return faces_[f].corners; }
  VertexOrder order(Index v) const { return orders_[v]; }
  /// The faces at v; before the first contraction exactly those, in the input's order, later with removed ones among
  /// them.
  std::span<const Index> faces_at(Index v) const { return face_lists_.of(v); }

  /// The vertex that v has been merged into, v itself if none. Shortens the path.
  Index representative(Index v) {
    while (vertices_[v].parent != v) {
      Index& parent = vertices_[v].parent;
      v = parent = vertices_[parent].parent;
    }
    return v;
  }

  /// Edges are numbered along the vertices. Where a contraction makes one of two edges, one of them lives on.
  std::size_t n_edge_slots() const { return edges_.size(); }
  bool is_edge_alive(Index e) const { return edge_alive_[e]; }
  /// The vertices that the ends of e have been merged into.
  Edge ends(Index e) {
    Edge& edge = edges_[e];
    edge = {representative(edge.first), representative(edge.second)};
    return edge;
  }
  /// The same before the first contraction.
  Edge initial_ends(Index e) const { return edges_[e]; }
  /// The edge from corner i of face f to the next.
  Index face_edge(Index f, std::size_t i) const { return faces_[f].edges[i]; }
  /// Number of faces at an edge of the input, at most 255.
  unsigned n_initial_edge_faces(Index e) const { return n_edge_faces_[e]; }

  void gather(Index a, Index b, PairStar& star);

  /// Whether contracting (a, b) leaves the topology as it is: Lk a ∩ Lk b = Lk ab, borders and non-manifold lines seen
  /// as joined to a cone vertex. \cite dey_1999_topology
  bool link_condition(Index a, Index b, const PairStar& star) {
    return obviously_keeps_topology(a, b, star) || link_condition_of_any(a, b, star);
  }

  /// Merges `removed` into `survivor`, which moves to `position`. `star` as gathered for (survivor, removed).
  void contract(Index survivor, Index removed, const Vec3& position, const PairStar& star);

  void prefetch_edge(Index e) const { prefetch(&edges_[e]); }
  void prefetch_ends(Index e) const {
    prefetch(&vertices_[edges_[e].first]);
    prefetch(&vertices_[edges_[e].second]);
  }
  void prefetch_vertex(Index v) const { prefetch(&vertices_[v]); }
  void prefetch_face_list(Index v) const { face_lists_.prefetch(v); }
  void prefetch_faces(Index v) const {
    for (const Index f : face_lists_.of(v)) prefetch(&faces_[f]);
  }
  void prefetch_neighbours(Index v) const {
    for (const Index f : face_lists_.of(v)) {
      if (!is_alive(f)) continue;
      for (const Index w : faces_[f].corners) prefetch_vertex(w);
    }
  }

 private:
  void number_vertices(const std::vector<Vec3>& positions, std::vector<Index>& number_of);
  void number_faces(std::span<const Triangle> faces, const std::vector<Index>& number_of);
  void list_faces(unsigned threads);
  void number_edges();
  Index number_edge(Index v, Index w, std::size_t first);
  void find_orders(unsigned threads);
  bool is_small_closed_fan(Index v) const;
  void gather_ring(Index v);
  VertexOrder order_of_ring() const;
  Index place_in_ring(Index v);
  void gather_one(Index v, Index other, std::vector<PairStar::Wing>& wings, std::vector<PairStar::Shared>* shared);
  bool link_condition_of_any(Index a, Index b, const PairStar& star);
  bool obviously_keeps_topology(Index a, Index b, const PairStar& star) const;
  void merge_edges(const PairStar::Shared& shared, Index survivor, Index removed, const PairStar& star);

  /// What is looked at together lies together: two vertices a cache line.
  struct alignas(32) Vertex {
    Vec3 position;
    Index parent;  ///< towards the vertex it was merged into; itself if none
    Index origin;
  };
  struct Face {
    Triangle corners;            ///< the first is `invalid_index` once removed
    std::array<Index, 3> edges;  ///< from each corner to the next
  };
  std::vector<Vertex> vertices_;
  std::vector<VertexOrder> orders_;
  std::vector<Face> faces_;
  std::vector<Index> face_origins_;
  FaceLists face_lists_;
  std::vector<Edge> edges_;  ///< ends as last looked up
  std::vector<bool> edge_alive_;
  std::vector<std::uint8_t> n_edge_faces_;
  std::uint64_t n_vertices_ = 0;
  std::uint64_t n_faces_ = 0;
  std::uint64_t n_degenerate_faces_ = 0;

  /// A neighbour of one vertex or of a pair, with the number of faces at its edges to them.
  struct RingEntry {
    Index vertex;
    std::array<Index, 2> n_faces{};                           ///< at the edge to the first and the second vertex
    std::array<Index, 2> next{invalid_index, invalid_index};  ///< places of up to two neighbours in the link
    bool opposite = false;                                    ///< corner of a face of the pair
  };
  /// Scratch: the neighbours under look, and each vertex's place among them (at first: among the edges), right only if
  /// the entry there names it.
  std::vector<RingEntry> ring_;
  std::vector<Index> ring_place_;
};

}  // namespace whittle
