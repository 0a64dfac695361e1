#include "complex/triangle_complex.hh"

#include <algorithm>
#include <cassert>

namespace whittle {

std::vector<Index> TriangleComplex::vertices_by_origin() const {
  std::vector<Index> vertices(n_vertex_slots());
  for (Index v = 0; v < vertices.size(); ++v) vertices[origin(v)] = v;
  return vertices;
}

Index TriangleComplex::root(Index v) {
  for (Index above = parent(v); above != v; above = parent(v)) v = above;
  return v;
}

/// Looks at v's list with live neighbours. \return the faces without `other`
StarFaces TriangleComplex::gather_one(Index v, Index other, GatheredStar& star) {
  star.opposites.clear();
  return is_ring(v) ? gather_ring(v, other, star) : gather_pairs(v, other, star);
}

/// Opens the ring at `other`: the rest is a fan from the one opposite corner to the other.
StarFaces TriangleComplex::gather_ring(Index v, Index other, GatheredStar& star) {
  const std::span<const Neighbour> ring = neighbours(v);
  if (star.neighbours.size() < 2 * ring.size()) star.neighbours.resize(4 * ring.size());
  // Where a face has vanished, two neighbours in succession have become one.
  Neighbour* const neighbours = star.neighbours.data();
  std::size_t n = 0;
  std::size_t n_until_other = 0;
  Index last = representative(ring.back().vertex);
  for (const Neighbour& then : ring) {
    const Neighbour now{representative(then.vertex), then.edge};
    neighbours[n] = now;
    n += static_cast<std::size_t>(now.vertex != last);
    n_until_other = now.vertex == other ? n : n_until_other;
    last = now.vertex;
  }
  if (n_until_other == 0) {  // the whole ring
    neighbours[n] = neighbours[0];
    return StarFaces::of_fan({neighbours, n + 1});
  }
  std::copy_n(neighbours, n_until_other, neighbours + n);
  const std::span<const Neighbour> fan(neighbours + n_until_other, n - 1);
  star.opposites.push_back(fan.front());
  star.opposites.push_back(fan.back());
  return StarFaces::of_fan(fan);
}

StarFaces TriangleComplex::gather_pairs(Index v, Index other, GatheredStar& star) {
  const std::span<const Neighbour> list = neighbours(v);
  star.neighbours.clear();
  for (std::size_t i = 0; i < list.size(); i += 2) {
    const Neighbour x{representative(list[i].vertex), list[i].edge};
    const Neighbour y{representative(list[i + 1].vertex), list[i + 1].edge};
    if (x.vertex == y.vertex) continue;
    if (x.vertex == other || y.vertex == other) {
      star.opposites.push_back(x.vertex == other ? y : x);
    } else {
      star.neighbours.insert(star.neighbours.end(), {x, y});
    }
  }
  return StarFaces::of_pairs(star.neighbours);
}

/// A ring loses a neighbour where two in succession have become one, pairs lose a face.
void TriangleComplex::compact(Index v) {
  const std::span<Neighbour> list = neighbour_lists_.of(stars_[v].list);
  for (Neighbour& neighbour : list) neighbour = {representative(neighbour.vertex), live_edge(neighbour.edge)};
  std::size_t n = 0;
  if (is_ring(v)) {
    Index last = list.empty() ? invalid_index : list.back().vertex;
    for (const Neighbour& neighbour : list) {
      if (neighbour.vertex == last) continue;
      last = neighbour.vertex;
      list[n++] = neighbour;
    }
  } else {
    for (std::size_t i = 0; i < list.size(); i += 2) {
      if (list[i].vertex == list[i + 1].vertex) continue;
      list[n++] = list[i];
      list[n++] = list[i + 1];
    }
  }
  stars_[v].list.size = static_cast<Index>(n);
}

int TriangleComplex::valence(Index v) const {
  const std::span<const Neighbour> list = neighbours(v);
  if (is_ring(v)) return static_cast<int>(list.size());
  std::vector<Index> others;
  for (const Neighbour& neighbour : list) others.push_back(neighbour.vertex);
  std::sort(others.begin(), others.end());
  return static_cast<int>(std::unique(others.begin(), others.end()) - others.begin());
}

void TriangleComplex::gather(const Pair& pair, ContractionProfile& profile) {
  profile.pair = pair;
  profile.is_nonmanifold = false;
  profile.has_ring = false;
  profile.first = gather_one(pair.a, pair.b, gathered_[0]);
  profile.second = gather_one(pair.b, pair.a, gathered_[1]);
  // The faces of both, as each of the two has them.
  std::vector<Neighbour>& from_a = gathered_[0].opposites;
  std::vector<Neighbour>& from_b = gathered_[1].opposites;
  assert(from_a.size() == from_b.size());
  if (from_a.size() == 2) {
    if (from_a[0].vertex != from_b[0].vertex) std::swap(from_b[0], from_b[1]);
  } else {
    const auto is_before = [](const Neighbour& x, const Neighbour& y) { return x.vertex < y.vertex; };
    std::sort(from_a.begin(), from_a.end(), is_before);
    std::sort(from_b.begin(), from_b.end(), is_before);
  }
  profile.opposites.clear();
  for (std::size_t i = 0; i < from_a.size(); ++i) {
    profile.opposites.push_back({from_a[i].vertex, {from_a[i].edge, from_b[i].edge}});
    for (const Index e : profile.opposites.back().edges) {
      pair_alive_.prefetch(e);
      prefetch_pair(e);  // in case it is merged into another
    }
  }
}

Index TriangleComplex::live_edge(Index e) const {
  while (!is_pair_alive(e)) e = pairs_[e].first;
  return e;
}

void TriangleComplex::list_live_pairs(Index v, std::vector<Neighbour>& pairs) {
  pairs.clear();
  const std::span<const Neighbour> list = neighbours(v);
  const std::size_t step = is_ring(v) ? 1 : 2;
  for (std::size_t i = 0; i < list.size(); i += step) {
    const Neighbour& y = list[i + 1 < list.size() ? i + 1 : 0];
    const Neighbour first{representative(list[i].vertex), list[i].edge};
    const Neighbour second{representative(y.vertex), y.edge};
    if (first.vertex != second.vertex) pairs.insert(pairs.end(), {first, second});
  }
}

bool TriangleComplex::have_common_face(Index a, Index b) {
  const std::span<const Neighbour> list = neighbours(a);
  if (is_ring(a)) {
    return std::any_of(list.begin(), list.end(),
                       [&](const Neighbour& neighbour) { return representative(neighbour.vertex) == b; });
  }
  for (std::size_t i = 0; i < list.size(); i += 2) {
    const Index x = representative(list[i].vertex);
    const Index y = representative(list[i + 1].vertex);
    if (x != y && (x == b || y == b)) return true;
  }
  return false;
}

// Contracting ---------------------------------------------------------------------------------------------------------

void TriangleComplex::contract(const ContractionProfile& profile, Index survivor, const Vec3& position,
                               Change& change) {
  const auto& [id, a, b] = profile.pair;
  const Index removed = survivor == a ? b : a;
  change.pair = profile.pair;
  change.survivor = survivor;
  change.removed = removed;
  change.before = {vertices_[a].position, vertices_[b].position};
  change.position = position;
  change.edges.clear();
  remove_pair(id);
  --n_vertices_;
  ++n_contractions_;
  parents_[removed] = survivor;
  if (!identities_.empty()) {
    const Identities after = identities_after(profile.pair, survivor, position);
    identities_[survivor] = after.survivor;
    identities_[removed] = after.removed;
  }
  vertices_[survivor].position = position;
  note_change(survivor);
  note_change(removed);
  n_faces_ -= profile.opposites.size();
  for (const ContractionProfile::Common& neighbour : profile.merged_neighbours()) merge_edges(neighbour, change);
  if (profile.is_nonmanifold) {
    merge_nonmanifold(survivor, removed, profile.nonmanifold);
  } else if (survivor == a) {
    merge_stars(survivor, removed, profile.first, profile.second);
  } else {
    merge_stars(survivor, removed, profile.second, profile.first);
  }
}

void TriangleComplex::follow_positions() {
  identities_.resize(vertices_.size());
  for (Index v = 0; v < identities_.size(); ++v) identities_[v] = origin(v);
}

TriangleComplex::Identities TriangleComplex::identities_after(const Pair& pair, Index survivor,
                                                              const Vec3& position) const {
  const Index removed = survivor == pair.a ? pair.b : pair.a;
  const bool is_at_removed = position == vertices_[removed].position && position != vertices_[survivor].position;
  if (identities_.empty() || !is_at_removed) return {identity(survivor), identity(removed)};
  return {identity(removed), identity(survivor)};
}

/// Of the two edges that become one, the first lives on.
void TriangleComplex::merge_edges(const ContractionProfile::Common& neighbour, Change& change) {
  const Index kept = live_edge(neighbour.edges[0]);
  const Index gone = live_edge(neighbour.edges[1]);
  change.edges.push_back({neighbour.vertex, {kept, gone}, kept});
  if (kept == gone) return;
  remove_pair(gone);
  pairs_[gone].first = kept;
}

/// The survivor gets the faces without the other vertex, in the first list, the second or a new one, whichever is the
/// first to have room. Two rings share the two opposite vertices.
void TriangleComplex::merge_stars(Index survivor, Index removed, const StarFaces& kept, const StarFaces& added) {
  Star& star = stars_[survivor];
  Star& other = stars_[removed];
  star.kind = std::max(star.kind, other.kind);
  star.is_ring &= other.is_ring;
  const std::size_t n = (star.is_ring ? 1 : 2) * (kept.size() + added.size());
  if (n > star.list.capacity) std::swap(star.list, other.list);
  if (n > star.list.capacity) {
    neighbour_lists_.release(star.list);
    star.list = neighbour_lists_.allocate(static_cast<Index>(n));
  }
  neighbour_lists_.release(other.list);
  other.list = {};
  star.list.size = static_cast<Index>(n);
  auto end = neighbour_lists_.of(star.list).begin();
  if (!star.is_ring) {
    for (const StarFaces& faces : {kept, added}) {
      for (std::size_t i = 0; i < faces.size(); ++i) end = std::copy_n(faces.corners_of(i).begin(), 2, end);
    }
    return;
  }
  const std::span<const Neighbour> first = kept.neighbours();
  const std::span<const Neighbour> second = added.neighbours();
  end = std::copy(first.begin(), first.end(), end);
  if (second.size() <= 2) return;
  assert(second.front().vertex == first.back().vertex);
  std::copy(second.begin() + 1, second.end() - 1, end);
}

void TriangleComplex::merge_nonmanifold(Index survivor, Index removed,
                                        const ContractionProfile::NonmanifoldPlan& nonmanifold) {
  for (const Index edge : nonmanifold.lost_edges) remove_pair(live_edge(edge));
  neighbour_lists_.release(stars_[removed].list);
  stars_[removed] = {};
  n_faces_ -= nonmanifold.coincident.size();
  n_coincident_faces_ += nonmanifold.coincident.size();
  std::vector<Neighbour> merged = nonmanifold.left[0];
  merged.insert(merged.end(), nonmanifold.left[1].begin(), nonmanifold.left[1].end());
  set_star(survivor, merged);
  for (std::size_t i = 0; i < nonmanifold.common.size(); ++i)
    set_star(nonmanifold.common[i].vertex, nonmanifold.faces[i]);
}

/// \param pairs the faces that v has now
void TriangleComplex::set_star(Index v, std::span<const Neighbour> pairs) {
  Star& star = stars_[v];
  if (pairs.empty()) {
    neighbour_lists_.release(star.list);
    star = {};
    --n_vertices_;
    return;
  }
  link_.gather(pairs);
  star.kind = link_.kind();
  star.is_ring = star.kind == VertexKind::regular && link_.is_oriented();
  if (star.kind != VertexKind::regular) irregular_.push_back(v);
  const auto size = static_cast<Index>(star.is_ring ? pairs.size() / 2 : pairs.size());
  if (size > star.list.capacity) {
    neighbour_lists_.release(star.list);
    star.list = neighbour_lists_.allocate(size);
  }
  star.list.size = size;
  const std::span<Neighbour> list = neighbour_lists_.of(star.list);
  if (!star.is_ring) {
    std::copy(pairs.begin(), pairs.end(), list.begin());
    return;
  }
  std::vector<Index> edges(link_.entries().size());
  for (const Neighbour& neighbour : pairs) edges[link_.slot(neighbour.vertex)] = neighbour.edge;
  Index slot = 0;
  for (Neighbour& neighbour : list) {
    const Index edge = edges[slot];
    neighbour = {link_.step(slot), edge};
  }
}

// What is there -------------------------------------------------------------------------------------------------------

std::vector<Triangle> TriangleComplex::live_faces() {
  std::vector<Triangle> faces;
  faces.reserve(n_faces_);
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (parents_[v] != v) continue;
    live_pairs(v);
    for (std::size_t i = 0; i < live_.size(); i += 2) {
      const Triangle face{v, live_[i].vertex, live_[i + 1].vertex};
      if (v < face[1] && v < face[2]) faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

NonmanifoldCounts TriangleComplex::count_nonmanifold(bool with_edges_to_frozen) {
  for (Index& v : irregular_) v = representative(v);
  std::sort(irregular_.begin(), irregular_.end());
  irregular_.erase(std::unique(irregular_.begin(), irregular_.end()), irregular_.end());
  NonmanifoldCounts counts;
  for (const Index v : irregular_) {
    link_.gather(live_pairs(v));
    counts.vertices += static_cast<std::uint64_t>(link_.n_fans() > 1);
    for (const Link::Entry& entry : link_.entries()) {
      // An edge of two vertices that aren't frozen is seen from both.
      const bool is_counted_here = is_frozen(entry.vertex) ? with_edges_to_frozen : v < entry.vertex;
      counts.edges += static_cast<std::uint64_t>(entry.n_faces[0] > 2 && is_counted_here);
    }
  }
  return counts;
}

}  // namespace whittle
