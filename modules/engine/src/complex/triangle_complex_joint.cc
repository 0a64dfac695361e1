#include <algorithm>
#include <cassert>
#include <numeric>
#include <tuple>

#include "complex/triangle_complex.hh"

// Contractions that change the topology: those of threshold pairs, and those of edges that the link condition is
// against. They make the neighbourhood of the two vertices anew, where others just put two lists together.

namespace whittle {
namespace {

/// A face of one of the two stars.
struct StarFace {
  Index low, high;  ///< the other corners
  bool is_turned;   ///< the higher one comes first
  std::size_t side;
  std::size_t place;

  auto key() const { return std::tie(low, high, is_turned, side, place); }
  bool operator<(const StarFace& other) const { return key() < other.key(); }
};

std::vector<StarFace> sorted_faces(const std::array<const Wings*, 2>& stars) {
  std::vector<StarFace> faces;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t i = 0; i < stars[side]->size(); ++i) {
      const auto [x, y] = (*stars[side])[i];
      faces.push_back({std::min(x, y), std::max(x, y), x > y, side, i});
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// \param group faces over the same edge, sorted. \return which of them stays; their number if none does
std::size_t remaining_face(std::span<const StarFace> group) {
  const auto n_turned = static_cast<std::size_t>(
      std::count_if(group.begin(), group.end(), [](const StarFace& face) { return face.is_turned; }));
  const std::size_t n_not_turned = group.size() - n_turned;
  if (n_turned == n_not_turned) return group.size();
  return n_turned > n_not_turned ? n_not_turned : 0;
}

/// The neighbours of one vertex of a pair, ascending, each once.
std::vector<Spoke> sorted_neighbours(const Wings& wings, const PairStar& star, std::size_t side) {
  std::vector<Spoke> result(wings.spokes().begin(), wings.spokes().end());
  for (const PairStar::Opposite& opposite : star.opposites) result.push_back({opposite.vertex, opposite.edges[side]});
  std::sort(result.begin(), result.end(), [](const Spoke& x, const Spoke& y) { return x.vertex < y.vertex; });
  const auto is_same = [](const Spoke& x, const Spoke& y) { return x.vertex == y.vertex; };
  result.erase(std::unique(result.begin(), result.end(), is_same), result.end());
  return result;
}

bool contains(std::span<const Spoke> spokes, Index v) {
  return std::any_of(spokes.begin(), spokes.end(), [v](const Spoke& spoke) { return spoke.vertex == v; });
}

/// From faces in pairs, that of the corners x and y.
void erase_face(std::vector<Spoke>& pairs, Index x, Index y) {
  for (auto face = pairs.begin(); face != pairs.end(); face += 2) {
    if (face[0].vertex != x || face[1].vertex != y) continue;
    pairs.erase(face, face + 2);
    return;
  }
  assert(false);
}

void find_common_neighbours(const PairStar& star, std::vector<PairStar::Opposite>& common) {
  common.clear();
  const std::vector<Spoke> around_a = sorted_neighbours(star.first, star, 0);
  const std::vector<Spoke> around_b = sorted_neighbours(star.second, star, 1);
  auto y = around_b.begin();
  for (const Spoke& x : around_a) {
    while (y != around_b.end() && y->vertex < x.vertex) ++y;
    if (y != around_b.end() && y->vertex == x.vertex) common.push_back({x.vertex, {x.edge, y->edge}});
  }
}

/// Sorts the faces of both stars into those that vanish, as they would coincide, and those that are left.
void leave_out_coincident(PairStar& star) {
  const std::array<const Wings*, 2> stars{&star.first, &star.second};
  std::array<std::vector<bool>, 2> is_left_out{std::vector<bool>(star.first.size()),
                                               std::vector<bool>(star.second.size())};
  star.joint.coincident.clear();
  const std::vector<StarFace> faces = sorted_faces(stars);
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    bool is_on_both_sides = false;
    for (; end < faces.size() && faces[end].low == faces[begin].low && faces[end].high == faces[begin].high; ++end) {
      is_on_both_sides |= faces[end].side != faces[begin].side;
    }
    if (!is_on_both_sides) continue;
    const std::size_t remaining = begin + remaining_face(std::span(faces).subspan(begin, end - begin));
    for (std::size_t i = begin; i < end; ++i) {
      if (i == remaining) continue;
      is_left_out[faces[i].side][faces[i].place] = true;
      star.joint.coincident.push_back((*stars[faces[i].side])[faces[i].place]);
    }
  }
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<Spoke>& left = star.joint.left[side];
    left.clear();
    for (std::size_t i = 0; i < stars[side]->size(); ++i) {
      const auto face = stars[side]->spokes_of(i);
      if (!is_left_out[side][i]) left.insert(left.end(), face.begin(), face.end());
    }
  }
  star.first = Wings::of_pairs(star.joint.left[0]);
  star.second = Wings::of_pairs(star.joint.left[1]);
}

}  // namespace

// Planning ------------------------------------------------------------------------------------------------------------

void TriangleComplex::plan_joint(Index a, Index b, PairStar& star) {
  star.is_joint = true;
  find_common_neighbours(star, star.joint.common);
  leave_out_coincident(star);
  star.joint.faces.clear();
  star.joint.lost_edges.clear();
  for (const PairStar::Opposite& neighbour : star.joint.common) {
    plan_neighbour(neighbour.vertex, a, b, star.joint);
    if (!contains(star.joint.faces.back(), a)) star.joint.lost_edges.push_back(neighbour.edges[0]);
  }
}

/// What a common neighbour v of a and b is left with.
void TriangleComplex::plan_neighbour(Index v, Index a, Index b, PairStar::Joint& joint) {
  live_pairs(v);
  for (Spoke& spoke : live_) spoke.vertex = select(spoke.vertex == b, a, spoke.vertex);
  std::vector<Spoke>& faces = joint.faces.emplace_back();
  for (std::size_t i = 0; i < live_.size(); i += 2) {
    if (live_[i].vertex != live_[i + 1].vertex) faces.insert(faces.end(), {live_[i], live_[i + 1]});
  }
  for (const auto& [x, y] : joint.coincident) {
    if (x == v) erase_face(faces, y, a);
    if (y == v) erase_face(faces, a, x);
  }
  std::vector<Index> lost;  // what was at the other ends of edges that are lost
  for (const Spoke& spoke : live_) {
    const bool is_seen_from_here = spoke.vertex != a && v < spoke.vertex;  // each edge once
    if (!is_seen_from_here || contains(faces, spoke.vertex)) continue;
    if (std::find(lost.begin(), lost.end(), spoke.vertex) != lost.end()) continue;
    lost.push_back(spoke.vertex);
    joint.lost_edges.push_back(spoke.edge);
  }
}

void TriangleComplex::add_defects(Index v, std::span<const Spoke> pairs, Defects& defects) {
  gather_link_of(pairs);
  defects.n_vertices += static_cast<std::size_t>(n_fans() > 1);
  for (const LinkEntry& entry : link_) {
    if (entry.n_faces[0] == 2) continue;
    defects.edges.push_back({std::min(v, entry.vertex), std::max(v, entry.vertex), entry.n_faces[0]});
  }
}

/// Border edges, non-manifold edges, non-manifold vertices.
std::array<std::size_t, 3> TriangleComplex::Defects::counts() {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto n_border = static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const Edge& edge) { return edge.n_faces == 1; }));
  return {n_border, edges.size() - n_border, n_vertices};
}

bool TriangleComplex::is_no_less_manifold(Index a, Index b, const PairStar& star) {
  const PairStar::Joint& joint = star.joint;
  std::vector<Spoke> merged = joint.left[0];
  merged.insert(merged.end(), joint.left[1].begin(), joint.left[1].end());
  const auto is_near_merged = [&](const Spoke& spoke) { return spoke.vertex == a || contains(merged, spoke.vertex); };
  const auto hangs_together = [&](const std::vector<Spoke>& faces) {
    return std::any_of(faces.begin(), faces.end(), is_near_merged);
  };
  if (!std::all_of(joint.faces.begin(), joint.faces.end(), hangs_together)) return false;
  Defects before;
  Defects after;
  add_defects(a, merged, after);
  for (const Index v : {a, b}) {
    live_pairs(v);
    add_defects(v, live_, before);
  }
  for (std::size_t i = 0; i < joint.common.size(); ++i) {
    const Index v = joint.common[i].vertex;
    add_defects(v, joint.faces[i], after);
    live_pairs(v);
    add_defects(v, live_, before);
  }
  const auto n_before = before.counts();
  const auto n_after = after.counts();
  return n_after[0] <= n_before[0] && n_after[1] <= n_before[1] && n_after[2] <= n_before[2];
}

// Doing ---------------------------------------------------------------------------------------------------------------

/// What `contract` does to the lists.
void TriangleComplex::join_neighbourhoods(Index survivor, Index removed, const PairStar& star) {
  const PairStar::Joint& joint = star.joint;
  for (const PairStar::Opposite& neighbour : joint.common) merge_edges(neighbour);
  for (const Index edge : joint.lost_edges) remove_pair(live_edge(edge));
  spoke_lists_.release(stars_[removed].spokes);
  stars_[removed] = {};
  n_faces_ -= joint.coincident.size();
  n_coincident_faces_ += joint.coincident.size();
  std::vector<Spoke> merged = joint.left[0];
  merged.insert(merged.end(), joint.left[1].begin(), joint.left[1].end());
  set_star(survivor, merged);
  for (std::size_t i = 0; i < joint.common.size(); ++i) set_star(joint.common[i].vertex, joint.faces[i]);
}

std::span<const Spoke> TriangleComplex::live_pairs(Index v) {
  live_.clear();
  const std::span<const Spoke> list = neighbours(v);
  const std::size_t step = is_ring(v) ? 1 : 2;
  for (std::size_t i = 0; i < list.size(); i += step) {
    const Spoke& y = list[i + 1 < list.size() ? i + 1 : 0];
    const Spoke first{representative(list[i].vertex), list[i].edge};
    const Spoke second{representative(y.vertex), y.edge};
    if (first.vertex != second.vertex) live_.insert(live_.end(), {first, second});
  }
  return live_;
}

bool TriangleComplex::have_common_face(Index a, Index b) {
  const std::span<const Spoke> list = neighbours(a);
  if (is_ring(a)) {
    return std::any_of(list.begin(), list.end(), [&](const Spoke& spoke) { return representative(spoke.vertex) == b; });
  }
  for (std::size_t i = 0; i < list.size(); i += 2) {
    const Index x = representative(list[i].vertex);
    const Index y = representative(list[i + 1].vertex);
    if (x != y && (x == b || y == b)) return true;
  }
  return false;
}

void TriangleComplex::gather_link_of(std::span<const Spoke> pairs) {
  faces_.clear();
  for (std::size_t i = 0; i < pairs.size(); i += 2) faces_.push_back({pairs[i].vertex, pairs[i + 1].vertex});
  gather_link(faces_);
}

/// \param pairs the faces that v has now
void TriangleComplex::set_star(Index v, std::span<const Spoke> pairs) {
  Star& star = stars_[v];
  if (pairs.empty()) {
    spoke_lists_.release(star.spokes);
    star = {};
    --n_vertices_;
    return;
  }
  gather_link_of(pairs);
  star.order = order_of_link();
  star.is_ring = star.order == VertexOrder::regular && is_link_oriented();
  if (star.order != VertexOrder::regular) irregular_.push_back(v);
  const auto size = static_cast<Index>(star.is_ring ? pairs.size() / 2 : pairs.size());
  if (size > star.spokes.capacity) {
    spoke_lists_.release(star.spokes);
    star.spokes = spoke_lists_.allocate(size);
  }
  star.spokes.size = size;
  const std::span<Spoke> list = spoke_lists_.of(star.spokes);
  if (!star.is_ring) {
    std::copy(pairs.begin(), pairs.end(), list.begin());
    return;
  }
  std::vector<Index> edges(link_.size());
  for (const Spoke& spoke : pairs) edges[place_in_link(spoke.vertex)] = spoke.edge;
  Index place = 0;
  for (Spoke& spoke : list) {
    const Index edge = edges[place];
    spoke = {step_along_link(place), edge};
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

/// Sets of faces that are connected over edges at the vertex whose link is gathered.
std::size_t TriangleComplex::n_fans() {
  std::vector<Index> fan(link_.size());
  std::iota(fan.begin(), fan.end(), Index{0});
  const auto find = [&fan](Index place) {
    while (fan[place] != place) place = fan[place] = fan[fan[place]];
    return place;
  };
  std::size_t n = fan.size();
  for (const auto& [x, y] : faces_) {
    const Index at_x = find(place_in_link(x));
    const Index at_y = find(place_in_link(y));
    n -= static_cast<std::size_t>(at_x != at_y);
    fan[at_x] = at_y;
  }
  return n;
}

NonmanifoldCounts TriangleComplex::count_nonmanifold() {
  for (Index& v : irregular_) v = representative(v);
  std::sort(irregular_.begin(), irregular_.end());
  irregular_.erase(std::unique(irregular_.begin(), irregular_.end()), irregular_.end());
  NonmanifoldCounts counts;
  for (const Index v : irregular_) {
    live_pairs(v);
    gather_link_of(live_);
    counts.vertices += static_cast<std::uint64_t>(n_fans() > 1);
    for (const LinkEntry& entry : link_) {
      counts.edges += static_cast<std::uint64_t>(entry.n_faces[0] > 2 && v < entry.vertex);  // seen from both ends
    }
  }
  return counts;
}

}  // namespace whittle
