#include "whittle/engine/triangle_complex.hh"

#include <algorithm>
#include <stdexcept>

#include "space_filling_curve.hh"
#include "whittle/engine/parallel.hh"
#include "whittle/engine/select.hh"

namespace whittle {
namespace {

constexpr std::ptrdiff_t few_edges = 8;  ///< so many are searched one by one

/// Calls `use(corner)` for those for which `is_chosen(corner)`. As that can't be foretold, short lists are sifted
/// first, without a branch.
template <class IsChosen, class Use>
void for_each_chosen(std::span<Corner> list, const IsChosen& is_chosen, const Use& use) {
  constexpr std::size_t few = 16;
  if (list.size() > few) {
    for (Corner& corner : list) {
      if (is_chosen(corner)) use(corner);
    }
    return;
  }
  std::array<Corner*, few> chosen;
  std::size_t n = 0;
  for (Corner& corner : list) {
    chosen[n] = &corner;
    n += static_cast<std::size_t>(is_chosen(corner));
  }
  for (std::size_t i = 0; i < n; ++i) use(*chosen[i]);
}

}  // namespace

TriangleComplex::TriangleComplex(std::span<const Vec3> positions, std::span<const Triangle> faces, const Frame& frame,
                                 unsigned threads) {
  std::vector<Index> number_of;
  number_vertices(positions, frame, number_of);
  list_corners(faces, number_of);
  number_edges(threads);
  find_orders(threads);
}

void TriangleComplex::number_vertices(std::span<const Vec3> positions, const Frame& frame,
                                      std::vector<Index>& number_of) {
  const std::vector<Index> order = morton_order(positions, frame);
  number_of.resize(positions.size());
  vertices_.resize(positions.size());
  parents_.resize(positions.size());
  quadrics_.resize(positions.size());
  for (Index v = 0; v < order.size(); ++v) {
    number_of[order[v]] = v;
    vertices_[v] = {frame.to_frame(positions[order[v]]), order[v]};
    parents_[v] = v;
  }
}

/// Each vertex's corners in the input's order of faces, so that sums over them do not depend on the numbering in here.
void TriangleComplex::list_corners(std::span<const Triangle> faces, const std::vector<Index>& number_of) {
  const auto is_degenerate = [](const Triangle& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; };
  std::vector<Index> sizes(vertices_.size());
  for (const Triangle& face : faces) {
    if (is_degenerate(face)) {
      ++n_degenerate_faces_;
    } else {
      for (const Index v : face) ++sizes[number_of[v]];
    }
  }
  n_faces_ = faces.size() - n_degenerate_faces_;
  corner_lists_ = CornerLists(sizes);
  stars_.resize(vertices_.size());
  std::vector<Corner*> ends(vertices_.size());
  for (Index v = 0; v < vertices_.size(); ++v) {
    stars_[v].corners = corner_lists_.allocate(sizes[v]);
    stars_[v].corners.size = sizes[v];
    ends[v] = corner_lists_.of(stars_[v].corners).data();
    n_vertices_ += sizes[v] > 0 ? 1 : 0;
  }
  for (const Triangle& face : faces) {
    if (is_degenerate(face)) continue;
    const auto [a, b, c] = Triangle{number_of[face[0]], number_of[face[1]], number_of[face[2]]};
    *ends[a]++ = {b, c, invalid_index};
    *ends[b]++ = {c, a, invalid_index};
    *ends[c]++ = {a, b, invalid_index};
  }
}

/// Edges by their lower, then their higher vertex; the number of faces at each.
void TriangleComplex::number_edges(unsigned threads) {
  edges_.reserve(n_faces_ + n_faces_ / 2 + 16);
  n_edge_faces_.reserve(edges_.capacity());
  std::vector<Index> starts(vertices_.size() + 1);
  ring_place_.resize(vertices_.size());
  for (Index v = 0; v < vertices_.size(); ++v) {
    const std::size_t first = edges_.size();
    const auto count = [&](Index w) {
      Index& place = ring_place_[w];
      if (place < first || place >= edges_.size() || edges_[place].second != w) {
        place = static_cast<Index>(edges_.size());
        edges_.push_back({v, w});
        n_edge_faces_.push_back(0);
      }
      if (n_edge_faces_[place] < 255) ++n_edge_faces_[place];
      return place;
    };
    const std::span<Corner> list = corner_lists_.of(stars_[v].corners);
    for_each_chosen(
        list, [v](const Corner& corner) { return corner.next > v; },
        [&](Corner& corner) { corner.edge = count(corner.next); });
    for_each_chosen(
        list, [v](const Corner& corner) { return corner.previous > v; },
        [&](Corner& corner) { count(corner.previous); });
    if (std::ssize(edges_) - static_cast<std::ptrdiff_t>(first) > few_edges) sort_edges(v, first);
    if (edges_.size() >= invalid_index) throw std::length_error("decimate: more than 2^32 - 2 edges");
    starts[v + 1] = static_cast<Index>(edges_.size());
  }
  edge_alive_.assign(edges_.size() / 64 + 1, ~std::uint64_t{0});

  const auto edge_from_lower = [&](Index v, Index w) {
    const auto begin = edges_.begin() + starts[v];
    const auto end = edges_.begin() + starts[v + 1];
    const auto edge =
        end - begin <= few_edges
            ? std::find_if(begin, end, [w](const Edge& e) { return e.second == w; })
            : std::lower_bound(begin, end, w, [](const Edge& e, Index sought) { return e.second < sought; });
    return static_cast<Index>(edge - edges_.begin());
  };
  for_each_range(vertices_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      for_each_chosen(
          corner_lists_.of(stars_[v].corners), [v](const Corner& corner) { return corner.next < v; },
          [&](Corner& corner) { corner.edge = edge_from_lower(corner.next, static_cast<Index>(v)); });
    }
  });
}

/// Renumbers the edges from `first` on, all those from v to higher vertices, by the higher one.
void TriangleComplex::sort_edges(Index v, std::size_t first) {
  struct Numbered {
    Index vertex;
    std::uint8_t n_faces;
  };
  std::vector<Numbered> sorted;
  for (std::size_t e = first; e < edges_.size(); ++e) sorted.push_back({edges_[e].second, n_edge_faces_[e]});
  std::sort(sorted.begin(), sorted.end(), [](const Numbered& x, const Numbered& y) { return x.vertex < y.vertex; });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const std::size_t e = first + i;
    edges_[e] = {v, sorted[i].vertex};
    n_edge_faces_[e] = sorted[i].n_faces;
    ring_place_[sorted[i].vertex] = static_cast<Index>(e);
  }
  for (Corner& corner : corner_lists_.of(stars_[v].corners)) {
    if (corner.next > v) corner.edge = ring_place_[corner.next];
  }
}

unsigned TriangleComplex::n_initial_faces_between(Index v, Index w) { return n_edge_faces_[edge_between(v, w)]; }

void TriangleComplex::find_orders(unsigned threads) {
  for_each_range(vertices_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      stars_[v].order = is_small_closed_fan(static_cast<Index>(v)) ? VertexOrder::regular : VertexOrder::junction;
    }
  });
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (stars_[v].order == VertexOrder::regular) continue;
    gather_ring(v);
    stars_[v].order = order_of_ring();
  }
}

/// Whether the faces at v, if they are few, are one fan around it with two at each edge. The common case, decided by
/// sorting them into a fan.
bool TriangleComplex::is_small_closed_fan(Index v) const {
  constexpr std::size_t few = 12;
  const std::span<const Corner> list = corners(v);
  if (list.size() < 3 || list.size() > few) return false;
  std::array<Corner, few> fan;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (n_edge_faces_[list[i].edge] != 2) return false;
    fan[i] = list[i];
  }
  for (std::size_t i = 1; i < list.size(); ++i) {
    std::size_t j = i;
    while (j < list.size() && fan[j].next != fan[i - 1].previous) ++j;
    if (j == list.size()) return false;  // of several fans, or not all of one orientation
    std::swap(fan[i], fan[j]);
  }
  return fan[list.size() - 1].previous == fan[0].next;
}

Index TriangleComplex::root(Index v) {
  while (parents_[v] != v) v = parents_[v] = parents_[parents_[v]];
  return v;
}

Index TriangleComplex::place_in_ring(Index v) {
  Index& place = ring_place_[v];
  if (place < ring_.size() && ring_[place].vertex == v) return place;
  place = static_cast<Index>(ring_.size());
  ring_.push_back({.vertex = v});
  return place;
}

void TriangleComplex::gather_ring(Index v) {
  ring_.clear();
  const auto join = [&](Index from, Index to) {
    RingEntry& entry = ring_[from];
    if (entry.n_faces[0] < 2) entry.next[entry.n_faces[0]] = to;
    ++entry.n_faces[0];
  };
  for (const Corner& corner : corners(v)) {
    const Index at_next = place_in_ring(corner.next);
    const Index at_previous = place_in_ring(corner.previous);
    join(at_next, at_previous);
    join(at_previous, at_next);
  }
}

VertexOrder TriangleComplex::order_of_ring() const {
  std::size_t n_ends = 0;
  Index start = 0;
  for (Index i = 0; i < ring_.size(); ++i) {
    if (ring_[i].n_faces[0] > 2) return VertexOrder::junction;
    if (ring_[i].n_faces[0] == 1) {
      ++n_ends;
      start = i;
    }
  }
  if (ring_.empty()) return VertexOrder::regular;
  if (n_ends != 0 && n_ends != 2) return VertexOrder::junction;
  // The link is a union of closed polygons and at most one open one: a single one if a walk along it meets them all.
  std::size_t n_met = 1;
  Index previous = start;
  Index here = ring_[start].next[0];
  while (here != start) {
    ++n_met;
    const auto& next = ring_[here].next;
    const Index ahead = next[0] == previous ? next[1] : next[0];
    if (ahead == invalid_index) break;
    previous = here;
    here = ahead;
  }
  if (n_met != ring_.size()) return VertexOrder::junction;
  return n_ends == 0 ? VertexOrder::regular : VertexOrder::line;
}

/// Brings v's list up to date: first the corners of faces without `other`, whose number it returns, then those with it.
/// Which are which can't be foretold, so there is no branch on it: each corner is written to both places, and stays in
/// one.
std::size_t TriangleComplex::gather_one(Index v, Index other) {
  const std::span<Corner> list = corner_lists_.of(stars_[v].corners);
  if (shared_.size() < list.size() + 1) shared_.resize(2 * list.size() + 1);
  std::size_t n = 0;
  std::size_t n_shared = 0;
  for (const Corner& then : list) {
    const Corner corner{representative(then.next), representative(then.previous), then.edge};
    prefetch(&edge_alive_[corner.edge / 64]);
    const bool is_there = (corner.next != corner.previous) & (corner.next != v) & (corner.previous != v);
    const bool is_shared = (corner.next == other) | (corner.previous == other);
    list[n] = corner;
    shared_[n_shared] = corner;
    n += static_cast<std::size_t>(is_there & !is_shared);
    n_shared += static_cast<std::size_t>(is_there & is_shared);
  }
  for (std::size_t i = 0; i < n_shared; ++i) list[n + i] = shared_[i];
  stars_[v].corners.size = static_cast<Index>(n + n_shared);
  return n;
}

void TriangleComplex::gather(Index a, Index b, PairStar& star) {
  star.first = corners(a).first(gather_one(a, b));
  star.second = corners(b).first(gather_one(b, a));
  star.opposites.clear();
  for (const Corner& corner : corners(a).subspan(star.first.size())) {
    const Index opposite = corner.next == b ? corner.previous : corner.next;
    star.opposites.push_back({opposite, {edge_between(a, opposite), edge_between(b, opposite)}});
    for (const Index e : star.opposites.back().edges) prefetch_edge(e);  // in case it is merged into another
  }
}

/// The common case without a look at any neighbour: an inner edge, and by a coarse look no common neighbour beside
/// the two opposite corners. False means no more than that a closer look is due.
bool TriangleComplex::obviously_keeps_topology(Index a, Index b, const PairStar& star) const {
  if (star.opposites.size() != 2 || stars_[a].order != VertexOrder::regular ||
      stars_[b].order != VertexOrder::regular) {
    return false;
  }
  // With one face each beside the common ones, both would lie over the same edge: a tetrahedron.
  if (star.first.size() < 2 && star.second.size() < 2) return false;
  const Index c = star.opposites[0].vertex;
  const Index d = star.opposites[1].vertex;
  if (c == d) return false;
  // A bit for each vertex, by six bits of its number: first the lowest six, then, if those collide, the next.
  const auto are_apart = [&](unsigned shift) {
    const auto signature = [c, d, shift](std::span<const Corner> wings) {
      const auto bit = [c, d, shift](Index v) {
        return static_cast<std::uint64_t>((v != c) & (v != d)) << (v >> shift & 63);
      };
      std::uint64_t bits = 0;
      for (const Corner& wing : wings) bits |= bit(wing.next) | bit(wing.previous);
      return bits;
    };
    return (signature(star.first) & signature(star.second)) == 0;
  };
  return are_apart(0) || are_apart(6);
}

bool TriangleComplex::link_condition_of_any(Index a, Index b, const PairStar& star) {
  if (star.opposites.empty()) return false;                     // not an edge
  if (star.first.empty() && star.second.empty()) return false;  // the part would vanish
  ring_.clear();
  const auto count_faces = [&](std::span<const Corner> wings, std::size_t side) {
    for (const Corner& wing : wings) {
      ++ring_[place_in_ring(wing.next)].n_faces[side];
      ++ring_[place_in_ring(wing.previous)].n_faces[side];
    }
  };
  for (const PairStar::Opposite& opposite : star.opposites) {
    RingEntry& entry = ring_[place_in_ring(opposite.vertex)];
    entry.opposite = true;
    ++entry.n_faces[0];
    ++entry.n_faces[1];
  }
  const std::size_t n_opposite = ring_.size();
  count_faces(star.first, 0);
  count_faces(star.second, 1);

  // A common neighbour that makes no face with the pair: a tunnel or a fold would close.
  for (std::size_t i = n_opposite; i < ring_.size(); ++i) {
    if (ring_[i].n_faces[0] != 0 && ring_[i].n_faces[1] != 0) return false;
  }
  // Two faces, one at each vertex, over the same edge of the link: they would coincide (a tetrahedron).
  const auto is_opposite = [&](Index v) { return ring_[place_in_ring(v)].opposite; };
  for (const Corner& wing : star.first) {
    if (!is_opposite(wing.next) || !is_opposite(wing.previous)) continue;
    for (const Corner& other : star.second) {
      if (std::minmax(other.next, other.previous) == std::minmax(wing.next, wing.previous)) return false;
    }
  }
  // The cone vertex over irregular edges: two such vertices may only merge along such an edge, not when a third one
  // makes a triangle of such edges with them (a hole of three edges, a lone face), and not when both are junctions.
  if (stars_[a].order == VertexOrder::regular || stars_[b].order == VertexOrder::regular) return true;
  if (star.opposites.size() == 2) return false;
  if (stars_[a].order == VertexOrder::junction && stars_[b].order == VertexOrder::junction) return false;
  return std::none_of(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(n_opposite),
                      [](const RingEntry& entry) { return entry.n_faces[0] != 2 && entry.n_faces[1] != 2; });
}

/// The edge that e has become by merging.
Index TriangleComplex::live_edge(Index e) const {
  while (!is_edge_alive(e)) e = edges_[e].first;
  return e;
}

/// The edge between two neighbours, v's list up to date, as its face has it: it may have been merged into another.
Index TriangleComplex::edge_between(Index v, Index w) {
  Index edge = invalid_index;
  for (const Corner& corner : corners(v)) edge = select(corner.next == w, corner.edge, edge);
  if (edge != invalid_index) return edge;
  for (const Corner& corner : corners(w)) {  // where v's side of the edge has no face, or one of another orientation
    if (representative(corner.next) == v) return corner.edge;
  }
  return invalid_index;
}

/// Of the two edges that become one, the first lives on.
void TriangleComplex::merge_edges(const PairStar::Opposite& opposite) {
  const Index kept = live_edge(opposite.edges[0]);
  const Index gone = live_edge(opposite.edges[1]);
  if (kept == gone) return;
  remove_edge(gone);
  edges_[gone].first = kept;
}

/// The survivor gets the corners of faces without the other vertex, in the first list, the second or a new one,
/// whichever is the first to have room.
void TriangleComplex::merge_corners(Index survivor, Index removed, const PairStar& star) {
  CornerLists::List kept = stars_[survivor].corners;
  CornerLists::List other = stars_[removed].corners;
  kept.size = static_cast<Index>(star.first.size());
  other.size = static_cast<Index>(star.second.size());
  const Index n = kept.size + other.size;
  if (n > kept.capacity && n <= other.capacity) std::swap(kept, other);
  if (n > kept.capacity) {
    CornerLists::List longer = corner_lists_.allocate(n);
    corner_lists_.append(longer, kept);
    corner_lists_.release(kept);
    kept = longer;
  }
  corner_lists_.append(kept, other);
  corner_lists_.release(other);
  stars_[survivor].corners = kept;
  stars_[removed].corners = {};
}

void TriangleComplex::contract(Index edge, Index survivor, Index removed, const PlacedQuadric& merged,
                               const PairStar& star) {
  for (const PairStar::Opposite& opposite : star.opposites) merge_edges(opposite);
  remove_edge(edge);
  merge_corners(survivor, removed, star);
  n_faces_ -= star.opposites.size();
  --n_vertices_;
  ++n_contractions_;
  parents_[removed] = survivor;
  vertices_[survivor].position = merged.position;
  stars_[survivor].order = std::max(stars_[survivor].order, stars_[removed].order);
  quadrics_[removed].last_change = n_contractions_;
  quadrics_[survivor] = {merged.quadric.a, merged.quadric.c, store_slope(merged.quadric.b, survivor), n_contractions_};
}

/// In the place of v's old one, if it had one.
Index TriangleComplex::store_slope(const Vec3& slope, Index v) {
  if (slope.isZero(0)) return invalid_index;
  Index place = quadrics_[v].slope;
  if (place == invalid_index) {
    place = static_cast<Index>(slopes_.size());
    slopes_.emplace_back();
  }
  slopes_[place] = slope;
  return place;
}

}  // namespace whittle
