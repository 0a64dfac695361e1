#include "whittle/engine/triangle_complex.hh"

#include <algorithm>

#include "space_filling_curve.hh"
#include "whittle/engine/parallel.hh"

namespace whittle {

void FaceLists::push_back_to_overflow(List& list, Index face) {
  if (list.count == inline_capacity) {
    Index slot;
    if (free_overflow_.empty()) {
      slot = static_cast<Index>(overflow_.size());
      overflow_.emplace_back();
    } else {
      slot = free_overflow_.back();
      free_overflow_.pop_back();
    }
    overflow_[slot].assign(list.faces.begin(), list.faces.end());
    list.faces[0] = slot;
  }
  overflow_[list.faces[0]].push_back(face);
  ++list.count;
}

void FaceLists::shrink_overflow(List& list, std::size_t count) {
  const Index slot = list.faces[0];
  std::vector<Index>& faces = overflow_[slot];
  faces.resize(count);
  if (count > inline_capacity) return;
  std::copy(faces.begin(), faces.end(), list.faces.begin());
  faces.clear();
  free_overflow_.push_back(slot);
}

TriangleComplex::TriangleComplex(std::vector<Vec3> positions, std::span<const Triangle> faces, unsigned threads) {
  std::vector<Index> number_of;
  number_vertices(positions, number_of);
  positions = {};
  number_faces(faces, number_of);
  list_faces(threads);
  number_edges();
  find_orders(threads);
}

void TriangleComplex::number_vertices(const std::vector<Vec3>& positions, std::vector<Index>& number_of) {
  const std::vector<Index> order = morton_order(positions);
  ring_place_.resize(positions.size());
  number_of.resize(positions.size());
  vertices_.resize(positions.size());
  for (Index v = 0; v < order.size(); ++v) {
    number_of[order[v]] = v;
    vertices_[v] = {positions[order[v]], v, order[v]};
  }
}

/// Faces by their lowest vertex number; where that is equal, in the input's order.
void TriangleComplex::number_faces(std::span<const Triangle> faces, const std::vector<Index>& number_of) {
  const auto renumbered = [&](const Triangle& f) {
    return Triangle{number_of[f[0]], number_of[f[1]], number_of[f[2]]};
  };
  const auto is_degenerate = [](const Triangle& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; };
  std::vector<Index> starts(vertices_.size() + 1);
  for (const Triangle& face : faces) {
    if (is_degenerate(face)) {
      ++n_degenerate_faces_;
    } else {
      ++starts[std::ranges::min(renumbered(face)) + 1];
    }
  }
  for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  n_faces_ = faces.size() - n_degenerate_faces_;
  faces_.resize(n_faces_);
  face_origins_.resize(n_faces_);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (is_degenerate(faces[f])) continue;
    const Triangle face = renumbered(faces[f]);
    const Index place = starts[std::ranges::min(face)]++;
    faces_[place].corners = face;
    face_origins_[place] = static_cast<Index>(f);
  }
}

/// Each vertex's faces, in the input's order, so that sums over them do not depend on the numbering in here.
void TriangleComplex::list_faces(unsigned threads) {
  face_lists_ = FaceLists(vertices_.size());
  for (Index f = 0; f < faces_.size(); ++f) {
    for (const Index v : faces_[f].corners) face_lists_.push_back(v, f);
  }
  const auto by_origin = [&](Index f, Index g) { return face_origins_[f] < face_origins_[g]; };
  for_each_range(vertices_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const std::span<Index> list = face_lists_.of(static_cast<Index>(v));
      if (!std::is_sorted(list.begin(), list.end(), by_origin)) std::sort(list.begin(), list.end(), by_origin);
    }
  });
  for (Index v = 0; v < vertices_.size(); ++v) n_vertices_ += face_lists_.of(v).empty() ? 0 : 1;
}

Index TriangleComplex::place_in_ring(Index v) {
  Index& place = ring_place_[v];
  if (place < ring_.size() && ring_[place].vertex == v) return place;
  place = static_cast<Index>(ring_.size());
  ring_.push_back({.vertex = v});
  return place;
}

namespace {

/// The corner of `face` that v is. Without branches: which one it is can't be foretold.
std::size_t corner_of(const Triangle& face, Index v) {
  return static_cast<std::size_t>(face[1] == v) + 2 * static_cast<std::size_t>(face[2] == v);
}
constexpr std::array<std::size_t, 5> corner_after{0, 1, 2, 0, 1};

/// The corners of `face` after v, in order.
std::array<Index, 2> others(const Triangle& face, Index v) {
  const std::size_t i = corner_of(face, v);
  return {face[corner_after[i + 1]], face[corner_after[i + 2]]};
}

}  // namespace

void TriangleComplex::number_edges() {
  edges_.reserve(n_faces_ + n_faces_ / 2 + 16);
  n_edge_faces_.reserve(edges_.capacity());
  for (Index v = 0; v < vertices_.size(); ++v) {
    const std::size_t first = edges_.size();
    for (const Index f : face_lists_.of(v)) {
      auto& [corners, edges] = faces_[f];
      const std::size_t here = corner_of(corners, v);
      const std::size_t next = corner_after[here + 1];
      const std::size_t previous = corner_after[here + 2];
      if (corners[next] > v) edges[here] = number_edge(v, corners[next], first);
      if (corners[previous] > v) edges[previous] = number_edge(v, corners[previous], first);
    }
  }
  edge_alive_.assign(edges_.size(), true);
}

/// The number of the edge (v, w), one more face at it; a new number unless it is among the edges from `first` on.
Index TriangleComplex::number_edge(Index v, Index w, std::size_t first) {
  Index& place = ring_place_[w];
  if (place < first || place >= edges_.size() || edges_[place].second != w) {
    place = static_cast<Index>(edges_.size());
    edges_.push_back({v, w});
    n_edge_faces_.push_back(0);
  }
  if (n_edge_faces_[place] < 255) ++n_edge_faces_[place];
  return place;
}

void TriangleComplex::find_orders(unsigned threads) {
  orders_.resize(vertices_.size());
  for_each_range(vertices_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      orders_[v] = is_small_closed_fan(static_cast<Index>(v)) ? VertexOrder::regular : VertexOrder::junction;
    }
  });
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (orders_[v] == VertexOrder::regular) continue;
    gather_ring(v);
    orders_[v] = order_of_ring();
  }
}

/// Whether the faces at v, if they are few, are one fan around it with two at each edge. The common case, decided by
/// sorting them into a fan.
bool TriangleComplex::is_small_closed_fan(Index v) const {
  constexpr std::size_t few = 12;
  const std::span<const Index> list = face_lists_.of(v);
  if (list.size() < 3 || list.size() > few) return false;
  std::array<std::array<Index, 2>, few> fan;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& [corners, edges] = faces_[list[i]];
    const std::size_t here = corner_of(corners, v);
    if (n_edge_faces_[edges[here]] != 2 || n_edge_faces_[edges[corner_after[here + 2]]] != 2) return false;
    fan[i] = {corners[corner_after[here + 1]], corners[corner_after[here + 2]]};
  }
  for (std::size_t i = 1; i < list.size(); ++i) {
    const Index end = fan[i - 1][1];
    std::size_t j = i;
    while (j < list.size() && fan[j][0] != end) ++j;
    if (j == list.size()) return false;  // of several fans, or not all of one orientation
    std::swap(fan[i], fan[j]);
  }
  return fan[list.size() - 1][1] == fan[0][0];
}

void TriangleComplex::gather_ring(Index v) {
  ring_.clear();
  const auto join = [&](Index from, Index to) {
    RingEntry& entry = ring_[from];
    if (entry.n_faces[0] < 2) entry.next[entry.n_faces[0]] = to;
    ++entry.n_faces[0];
  };
  for (const Index f : face_lists_.of(v)) {
    const auto [x, y] = others(faces_[f].corners, v);
    const Index at_x = place_in_ring(x);
    const Index at_y = place_in_ring(y);
    join(at_x, at_y);
    join(at_y, at_x);
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

void TriangleComplex::gather_one(Index v, Index other, std::vector<PairStar::Wing>& wings,
                                 std::vector<PairStar::Shared>* shared) {
  const std::span<Index> list = face_lists_.of(v);
  wings.resize(list.size());
  std::size_t n_alive = 0;
  std::size_t n_wings = 0;
  for (const Index f : list) {
    if (!is_alive(f)) continue;
    list[n_alive++] = f;
    const auto [x, y] = others(faces_[f].corners, v);
    if (x != other && y != other) {
      wings[n_wings++] = {f, x, y};
    } else if (shared) {
      shared->push_back({f, x == other ? y : x});
    }
  }
  wings.resize(n_wings);
  if (n_alive != list.size()) face_lists_.truncate(v, n_alive);
}

void TriangleComplex::gather(Index a, Index b, PairStar& star) {
  star.shared.clear();
  gather_one(a, b, star.first, &star.shared);
  gather_one(b, a, star.second, nullptr);
}

/// The common case without a look at any neighbour: an inner edge, and by a coarse signature no common neighbour beside
/// the two opposite corners. False means no more than that a closer look is due.
bool TriangleComplex::obviously_keeps_topology(Index a, Index b, const PairStar& star) const {
  if (star.shared.size() != 2 || orders_[a] != VertexOrder::regular || orders_[b] != VertexOrder::regular) return false;
  // With one face each beside the common ones, both would lie over the same edge: a tetrahedron.
  if (star.first.size() < 2 && star.second.size() < 2) return false;
  const Index c = star.shared[0].opposite;
  const Index d = star.shared[1].opposite;
  if (c == d) return false;
  const auto signature = [c, d](const std::vector<PairStar::Wing>& wings) {
    const auto bit = [c, d](Index v) { return v == c || v == d ? 0 : std::uint64_t{1} << (v & 63); };
    std::uint64_t bits = 0;
    for (const PairStar::Wing& wing : wings) bits |= bit(wing.x) | bit(wing.y);
    return bits;
  };
  return (signature(star.first) & signature(star.second)) == 0;
}

bool TriangleComplex::link_condition_of_any(Index a, Index b, const PairStar& star) {
  if (star.shared.empty()) return false;                        // not an edge
  if (star.first.empty() && star.second.empty()) return false;  // the part would vanish
  ring_.clear();
  const auto count_faces = [&](const std::vector<PairStar::Wing>& wings, std::size_t side) {
    for (const PairStar::Wing& wing : wings) {
      ++ring_[place_in_ring(wing.x)].n_faces[side];
      ++ring_[place_in_ring(wing.y)].n_faces[side];
    }
  };
  for (const PairStar::Shared& shared : star.shared) {
    RingEntry& entry = ring_[place_in_ring(shared.opposite)];
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
  for (const PairStar::Wing& wing : star.first) {
    if (!is_opposite(wing.x) || !is_opposite(wing.y)) continue;
    for (const PairStar::Wing& other : star.second) {
      if ((other.x == wing.x && other.y == wing.y) || (other.x == wing.y && other.y == wing.x)) return false;
    }
  }
  // The cone vertex over irregular edges: two such vertices may only merge along such an edge, not when a third one
  // makes a triangle of such edges with them (a hole of three edges, a lone face), and not when both are junctions.
  if (orders_[a] == VertexOrder::regular || orders_[b] == VertexOrder::regular) return true;
  if (star.shared.size() == 2) return false;
  if (orders_[a] == VertexOrder::junction && orders_[b] == VertexOrder::junction) return false;
  return std::none_of(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(n_opposite),
                      [](const RingEntry& entry) { return entry.n_faces[0] != 2 && entry.n_faces[1] != 2; });
}

/// Of the edges of a face that vanishes, that between the pair goes, and that of the removed vertex becomes one with
/// that of the survivor.
void TriangleComplex::merge_edges(const PairStar::Shared& shared, Index survivor, Index removed, const PairStar& star) {
  const auto edge_between = [&](Index f, Index v, Index w) -> Index& {
    auto& [corners, edges] = faces_[f];
    const std::size_t i = corner_of(corners, v);
    return edges[corners[corner_after[i + 1]] == w ? i : corner_after[i + 2]];
  };
  const Index kept = edge_between(shared.face, survivor, shared.opposite);
  const Index gone = edge_between(shared.face, removed, shared.opposite);
  edge_alive_[edge_between(shared.face, survivor, removed)] = false;
  edge_alive_[gone] = false;
  for (const PairStar::Wing& wing : star.second) {
    if (wing.x == shared.opposite || wing.y == shared.opposite)
      edge_between(wing.face, removed, shared.opposite) = kept;
  }
}

void TriangleComplex::contract(Index survivor, Index removed, const Vec3& position, const PairStar& star) {
  for (const PairStar::Shared& shared : star.shared) {
    merge_edges(shared, survivor, removed, star);
    faces_[shared.face].corners[0] = invalid_index;
  }
  face_lists_.truncate(survivor, 0);
  for (const PairStar::Wing& wing : star.first) face_lists_.push_back(survivor, wing.face);
  for (const PairStar::Wing& wing : star.second) {
    for (Index& corner : faces_[wing.face].corners) {
      if (corner == removed) corner = survivor;
    }
    face_lists_.push_back(survivor, wing.face);
  }
  face_lists_.truncate(removed, 0);
  vertices_[removed].parent = survivor;
  vertices_[survivor].position = position;
  orders_[survivor] = std::max(orders_[survivor], orders_[removed]);
  n_faces_ -= star.shared.size();
  --n_vertices_;
}

}  // namespace whittle
