#include "complex/triangle_complex.hh"

#include <algorithm>
#include <cassert>

#include "whittle/core/detail/select.hh"

namespace whittle {

Index TriangleComplex::root(Index v) {
  for (Index above = parent(v); above != v; above = parent(v)) v = above;
  return v;
}

/// Looks at v's list with what has become of the neighbours. \return the faces without `other`
Wings TriangleComplex::gather_one(Index v, Index other, GatheredStar& star) {
  star.opposites.clear();
  return is_ring(v) ? gather_ring(v, other, star) : gather_pairs(v, other, star);
}

/// Opens the ring at `other`: the rest is a fan from the one opposite corner to the other.
Wings TriangleComplex::gather_ring(Index v, Index other, GatheredStar& star) {
  const std::span<const Spoke> ring = neighbours(v);
  if (star.spokes.size() < 2 * ring.size()) star.spokes.resize(4 * ring.size());
  // Where a face has vanished, two neighbours in succession have become one.
  Spoke* const spokes = star.spokes.data();
  std::size_t n = 0;
  std::size_t n_until_other = 0;
  Index last = representative(ring.back().vertex);
  for (const Spoke& then : ring) {
    const Spoke now{representative(then.vertex), then.edge};
    spokes[n] = now;
    n += static_cast<std::size_t>(now.vertex != last);
    n_until_other = now.vertex == other ? n : n_until_other;
    last = now.vertex;
  }
  if (n_until_other == 0) {  // the whole ring
    spokes[n] = spokes[0];
    return Wings::of_fan({spokes, n + 1});
  }
  std::copy_n(spokes, n_until_other, spokes + n);
  const std::span<const Spoke> fan(spokes + n_until_other, n - 1);
  star.opposites.push_back(fan.front());
  star.opposites.push_back(fan.back());
  return Wings::of_fan(fan);
}

Wings TriangleComplex::gather_pairs(Index v, Index other, GatheredStar& star) {
  const std::span<const Spoke> list = neighbours(v);
  star.spokes.clear();
  for (std::size_t i = 0; i < list.size(); i += 2) {
    const Spoke x{representative(list[i].vertex), list[i].edge};
    const Spoke y{representative(list[i + 1].vertex), list[i + 1].edge};
    if (x.vertex == y.vertex) continue;
    if (x.vertex == other || y.vertex == other) {
      star.opposites.push_back(x.vertex == other ? y : x);
    } else {
      star.spokes.insert(star.spokes.end(), {x, y});
    }
  }
  return Wings::of_pairs(star.spokes);
}

/// A ring loses a neighbour where two in succession have become one, pairs lose a face.
void TriangleComplex::tidy(Index v) {
  const std::span<Spoke> list = spoke_lists_.of(stars_[v].spokes);
  for (Spoke& spoke : list) spoke = {representative(spoke.vertex), live_edge(spoke.edge)};
  std::size_t n = 0;
  if (is_ring(v)) {
    Index last = list.empty() ? invalid_index : list.back().vertex;
    for (const Spoke& spoke : list) {
      if (spoke.vertex == last) continue;
      last = spoke.vertex;
      list[n++] = spoke;
    }
  } else {
    for (std::size_t i = 0; i < list.size(); i += 2) {
      if (list[i].vertex == list[i + 1].vertex) continue;
      list[n++] = list[i];
      list[n++] = list[i + 1];
    }
  }
  stars_[v].spokes.size = static_cast<Index>(n);
}

int TriangleComplex::valence(Index v) const {
  const std::span<const Spoke> list = neighbours(v);
  if (is_ring(v)) return static_cast<int>(list.size());
  std::vector<Index> others;
  for (const Spoke& spoke : list) others.push_back(spoke.vertex);
  std::sort(others.begin(), others.end());
  return static_cast<int>(std::unique(others.begin(), others.end()) - others.begin());
}

void TriangleComplex::gather(Index a, Index b, PairStar& star) {
  star.first = gather_one(a, b, gathered_[0]);
  star.second = gather_one(b, a, gathered_[1]);
  // The faces of both, as each of the two has them.
  std::vector<Spoke>& from_a = gathered_[0].opposites;
  std::vector<Spoke>& from_b = gathered_[1].opposites;
  assert(from_a.size() == from_b.size());
  if (from_a.size() == 2) {
    if (from_a[0].vertex != from_b[0].vertex) std::swap(from_b[0], from_b[1]);
  } else {
    const auto is_before = [](const Spoke& x, const Spoke& y) { return x.vertex < y.vertex; };
    std::sort(from_a.begin(), from_a.end(), is_before);
    std::sort(from_b.begin(), from_b.end(), is_before);
  }
  star.opposites.clear();
  star.is_joint = false;
  for (std::size_t i = 0; i < from_a.size(); ++i) {
    star.opposites.push_back({from_a[i].vertex, {from_a[i].edge, from_b[i].edge}});
    for (const Index e : star.opposites.back().edges) {
      prefetch(&pair_alive_[e / 64]);
      prefetch_pair(e);  // in case it is merged into another
    }
  }
}

/// The common case without a look at any neighbour: an inner edge, and by a coarse look no common neighbour beside
/// the two opposite corners. False means no more than that a closer look is due.
bool TriangleComplex::obviously_keeps_topology(Index a, Index b, const PairStar& star) const {
  if (!is_ring(a) || !is_ring(b) || star.opposites.size() != 2) return false;
  // With one face each beside the common ones, both would lie over the same edge: a tetrahedron.
  if (star.first.size() < 2 && star.second.size() < 2) return false;
  if (star.first.empty() || star.second.empty()) return false;
  const auto between_opposites = [](const Wings& fan) { return fan.spokes().subspan(1, fan.size() - 1); };
  // A bit for each vertex, by six bits of its number: first the lowest six, then, if those collide, the next.
  const auto are_apart = [&](unsigned shift) {
    const auto signature = [shift](std::span<const Spoke> spokes) {
      std::uint64_t bits = 0;
      for (const Spoke& spoke : spokes) bits |= std::uint64_t{1} << (spoke.vertex >> shift & 63);
      return bits;
    };
    return (signature(between_opposites(star.first)) & signature(between_opposites(star.second))) == 0;
  };
  return are_apart(0) || are_apart(6);
}

bool TriangleComplex::link_condition_of_any(Index a, Index b, const PairStar& star) {
  if (star.opposites.empty()) return false;                     // not an edge
  if (star.first.empty() && star.second.empty()) return false;  // the part would vanish
  link_.clear();
  const auto count_faces = [&](const Wings& wings, std::size_t side) {
    for (std::size_t i = 0; i < wings.size(); ++i) {
      ++link_[place_in_link(wings[i].x)].n_faces[side];
      ++link_[place_in_link(wings[i].y)].n_faces[side];
    }
  };
  for (const PairStar::Opposite& opposite : star.opposites) {
    LinkEntry& entry = link_[place_in_link(opposite.vertex)];
    if (entry.opposite) return false;  // two faces on the same three corners: that corner may have no others
    entry.opposite = true;
    ++entry.n_faces[0];
    ++entry.n_faces[1];
  }
  const std::size_t n_opposite = link_.size();
  count_faces(star.first, 0);
  count_faces(star.second, 1);

  // A common neighbour that makes no face with the pair: a tunnel or a fold would close.
  for (std::size_t i = n_opposite; i < link_.size(); ++i) {
    if (link_[i].n_faces[0] != 0 && link_[i].n_faces[1] != 0) return false;
  }
  // Two faces, one at each vertex, over the same edge of the link: they would coincide (a tetrahedron).
  const auto is_opposite = [&](Index v) { return link_[place_in_link(v)].opposite; };
  for (std::size_t i = 0; i < star.first.size(); ++i) {
    const auto [x, y] = star.first[i];
    if (!is_opposite(x) || !is_opposite(y)) continue;
    for (std::size_t j = 0; j < star.second.size(); ++j) {
      const auto [p, q] = star.second[j];
      if (std::minmax(p, q) == std::minmax(x, y)) return false;
    }
  }
  // The cone vertex over irregular edges: two such vertices may only merge along such an edge, not when a third one
  // makes a triangle of such edges with them (a hole of three edges, a lone face), and not when both are junctions.
  if (stars_[a].order == VertexOrder::regular || stars_[b].order == VertexOrder::regular) return true;
  if (star.opposites.size() == 2) return false;
  if (stars_[a].order == VertexOrder::junction && stars_[b].order == VertexOrder::junction) return false;
  return std::none_of(link_.begin(), link_.begin() + static_cast<std::ptrdiff_t>(n_opposite),
                      [](const LinkEntry& entry) { return entry.n_faces[0] != 2 && entry.n_faces[1] != 2; });
}

Index TriangleComplex::live_edge(Index e) const {
  while (!is_pair_alive(e)) e = pairs_[e].first;
  return e;
}

/// Of the two edges that become one, the first lives on.
void TriangleComplex::merge_edges(const PairStar::Opposite& opposite) {
  const Index kept = live_edge(opposite.edges[0]);
  const Index gone = live_edge(opposite.edges[1]);
  if (kept == gone) return;
  remove_pair(gone);
  pairs_[gone].first = kept;
}

/// The survivor gets the faces without the other vertex, in the first list, the second or a new one, whichever is the
/// first to have room.
void TriangleComplex::merge_stars(Index survivor, Index removed, const PairStar& star) {
  Star& kept = stars_[survivor];
  Star& other = stars_[removed];
  kept.order = std::max(kept.order, other.order);
  kept.is_ring &= other.is_ring;
  const std::size_t n = n_merged(star, kept.is_ring);
  if (n > kept.spokes.capacity) std::swap(kept.spokes, other.spokes);
  if (n > kept.spokes.capacity) {
    spoke_lists_.release(kept.spokes);
    kept.spokes = spoke_lists_.allocate(static_cast<Index>(n));
  }
  spoke_lists_.release(other.spokes);
  other.spokes = {};
  kept.spokes.size = static_cast<Index>(n);
  join(star, kept.is_ring, spoke_lists_.of(kept.spokes));
}

/// How long the merged list is. Two rings share the two opposite corners.
std::size_t TriangleComplex::n_merged(const PairStar& star, bool is_ring) {
  return is_ring ? star.first.size() + star.second.size() : 2 * (star.first.size() + star.second.size());
}

void TriangleComplex::join(const PairStar& star, bool is_ring, std::span<Spoke> spokes) {
  auto end = spokes.begin();
  if (!is_ring) {
    for (const Wings& wings : {star.first, star.second}) {
      for (std::size_t i = 0; i < wings.size(); ++i) end = std::copy_n(wings.spokes_of(i).begin(), 2, end);
    }
    return;
  }
  const std::span<const Spoke> first = star.first.spokes();
  const std::span<const Spoke> second = star.second.spokes();
  end = std::copy(first.begin(), first.end(), end);
  if (second.size() <= 2) return;
  assert(second.front().vertex == first.back().vertex);
  const std::span<const Spoke> inner = second.subspan(1, second.size() - 2);
  std::copy(inner.begin(), inner.end(), end);
}

void TriangleComplex::contract(Index pair, Index survivor, Index removed, const PlacedQuadric& merged,
                               const PairStar& star) {
  remove_pair(pair);
  if (!points_.empty()) merge_points(pair, survivor, removed);
  --n_vertices_;
  ++n_contractions_;
  parents_[removed] = survivor;
  vertices_[survivor].position = merged.position;
  quadrics_[removed].last_change = n_contractions_;
  quadrics_[survivor] = {merged.quadric.a, merged.quadric.c, store_slope(merged.quadric.b, survivor), n_contractions_};
  n_faces_ -= star.opposites.size();
  if (star.is_joint) {
    join_neighbourhoods(survivor, removed, star);
  } else {
    for (const PairStar::Opposite& opposite : star.opposites) merge_edges(opposite);
    merge_stars(survivor, removed, star);
  }
}

/// Those of vertices joined by a threshold pair are in their quadric from now on.
void TriangleComplex::merge_points(Index pair, Index survivor, Index removed) {
  PointQuadric& merged = points_[survivor];
  if (is_threshold_pair(pair)) {
    merged = {};
  } else if (origin(survivor) < origin(removed)) {
    merged = merged + points_[removed];
  } else {
    merged = points_[removed] + merged;
  }
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
