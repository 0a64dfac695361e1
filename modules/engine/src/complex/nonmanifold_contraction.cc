#include "complex/nonmanifold_contraction.hh"

#include <algorithm>
#include <cassert>
#include <functional>
#include <tuple>

#include "whittle/core/detail/select.hh"

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

std::vector<StarFace> sorted_faces(const std::array<const StarFaces*, 2>& stars) {
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
std::vector<Neighbour> sorted_neighbours(const StarFaces& faces, const ContractionProfile& profile, std::size_t side) {
  std::vector<Neighbour> result(faces.neighbours().begin(), faces.neighbours().end());
  for (const ContractionProfile::Common& opposite : profile.opposites)
    result.push_back({opposite.vertex, opposite.edges[side]});
  std::sort(result.begin(), result.end(), [](const Neighbour& x, const Neighbour& y) { return x.vertex < y.vertex; });
  const auto is_same = [](const Neighbour& x, const Neighbour& y) { return x.vertex == y.vertex; };
  result.erase(std::unique(result.begin(), result.end(), is_same), result.end());
  return result;
}

bool contains(std::span<const Neighbour> neighbours, Index v) {
  return std::any_of(neighbours.begin(), neighbours.end(),
                     [v](const Neighbour& neighbour) { return neighbour.vertex == v; });
}

/// From faces in pairs, that of the corners x and y.
void erase_face(std::vector<Neighbour>& pairs, Index x, Index y) {
  for (auto face = pairs.begin(); face != pairs.end(); face += 2) {
    if (face[0].vertex != x || face[1].vertex != y) continue;
    pairs.erase(face, face + 2);
    return;
  }
  assert(false);
}

void find_common_neighbours(const ContractionProfile& profile, std::vector<ContractionProfile::Common>& common) {
  common.clear();
  const std::vector<Neighbour> around_a = sorted_neighbours(profile.first, profile, 0);
  const std::vector<Neighbour> around_b = sorted_neighbours(profile.second, profile, 1);
  auto y = around_b.begin();
  for (const Neighbour& x : around_a) {
    while (y != around_b.end() && y->vertex < x.vertex) ++y;
    if (y != around_b.end() && y->vertex == x.vertex) common.push_back({x.vertex, {x.edge, y->edge}});
  }
}

/// Sorts the faces of both stars into those that vanish, as they would coincide, and those that are left.
void leave_out_coincident(ContractionProfile& profile) {
  const std::array<const StarFaces*, 2> stars{&profile.first, &profile.second};
  std::array<std::vector<bool>, 2> is_left_out{std::vector<bool>(profile.first.size()),
                                               std::vector<bool>(profile.second.size())};
  profile.nonmanifold.coincident.clear();
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
      profile.nonmanifold.coincident.push_back((*stars[faces[i].side])[faces[i].place]);
    }
  }
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<Neighbour>& left = profile.nonmanifold.left[side];
    left.clear();
    for (std::size_t i = 0; i < stars[side]->size(); ++i) {
      const auto face = stars[side]->corners_of(i);
      if (!is_left_out[side][i]) left.insert(left.end(), face.begin(), face.end());
    }
  }
  profile.first = StarFaces::of_pairs(profile.nonmanifold.left[0]);
  profile.second = StarFaces::of_pairs(profile.nonmanifold.left[1]);
}

/// What a common neighbour v of the pair is left with.
void plan_neighbour(TriangleComplex& complex, Index v, ContractionProfile& profile) {
  const auto& [id, a, b] = profile.pair;
  ContractionProfile::NonmanifoldPlan& nonmanifold = profile.nonmanifold;
  const std::span<const Neighbour> now = complex.live_pairs(v);
  std::vector<Neighbour> live(now.begin(), now.end());
  for (Neighbour& neighbour : live) neighbour.vertex = select_branch_free(neighbour.vertex == b, a, neighbour.vertex);
  std::vector<Neighbour>& faces = nonmanifold.faces.emplace_back();
  for (std::size_t i = 0; i < live.size(); i += 2) {
    if (live[i].vertex != live[i + 1].vertex) faces.insert(faces.end(), {live[i], live[i + 1]});
  }
  for (const auto& [x, y] : nonmanifold.coincident) {
    if (x == v) erase_face(faces, y, a);
    if (y == v) erase_face(faces, a, x);
  }
  std::vector<Index> lost;  // the other ends of lost edges
  for (const Neighbour& neighbour : live) {
    const bool is_seen_from_here = neighbour.vertex != a && v < neighbour.vertex;  // each edge once
    if (!is_seen_from_here || contains(faces, neighbour.vertex)) continue;
    if (std::find(lost.begin(), lost.end(), neighbour.vertex) != lost.end()) continue;
    lost.push_back(neighbour.vertex);
    nonmanifold.lost_edges.push_back(neighbour.edge);
  }
}

/// Where a surface is not a closed manifold.
struct Defects {
  struct Edge {
    Index low, high;
    std::size_t n_faces;
    auto operator<=>(const Edge&) const = default;
  };
  std::vector<Edge> edges;     ///< those that are not regular, or misoriented; some are listed twice
  std::size_t n_vertices = 0;  ///< of several fans

  void add(Link& link, Index v, std::span<const Neighbour> pairs) {
    link.gather(pairs);
    n_vertices += static_cast<std::size_t>(link.n_fans() > 1);
    for (const Link::Entry& entry : link.entries()) {
      if (entry.n_faces[0] == 2 && entry.n_ahead == 1) continue;
      edges.push_back({std::min(v, entry.vertex), std::max(v, entry.vertex), entry.n_faces[0]});
    }
  }

  /// Border edges, misoriented edges, non-manifold edges, non-manifold vertices.
  std::array<std::size_t, 4> counts() {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::array<std::size_t, 4> result{0, 0, 0, n_vertices};
    for (const Edge& edge : edges) ++result[std::min<std::size_t>(edge.n_faces, 3) - 1];
    return result;
  }
};

}  // namespace

void plan_nonmanifold(TriangleComplex& complex, ContractionProfile& profile) {
  profile.is_nonmanifold = true;
  ContractionProfile::NonmanifoldPlan& nonmanifold = profile.nonmanifold;
  find_common_neighbours(profile, nonmanifold.common);
  leave_out_coincident(profile);
  nonmanifold.faces.clear();
  nonmanifold.lost_edges.clear();
  for (const ContractionProfile::Common& neighbour : nonmanifold.common) {
    plan_neighbour(complex, neighbour.vertex, profile);
    if (!contains(nonmanifold.faces.back(), profile.pair.a)) nonmanifold.lost_edges.push_back(neighbour.edges[0]);
  }
}

namespace {

/// Border edges, misoriented edges, non-manifold edges and non-manifold vertices at the pair and its common neighbours.
struct DefectCounts {
  std::array<std::size_t, 4> before, after;
};

std::vector<Neighbour> merged_star(const ContractionProfile& profile) {
  std::vector<Neighbour> merged = profile.nonmanifold.left[0];
  merged.insert(merged.end(), profile.nonmanifold.left[1].begin(), profile.nonmanifold.left[1].end());
  return merged;
}

DefectCounts count_defects(TriangleComplex& complex, const ContractionProfile& profile) {
  const auto& [id, a, b] = profile.pair;
  const ContractionProfile::NonmanifoldPlan& nonmanifold = profile.nonmanifold;
  Link& link = complex.link();
  Defects before;
  Defects after;
  after.add(link, a, merged_star(profile));
  for (const Index v : {a, b}) before.add(link, v, complex.live_pairs(v));
  for (std::size_t i = 0; i < nonmanifold.common.size(); ++i) {
    const Index v = nonmanifold.common[i].vertex;
    after.add(link, v, nonmanifold.faces[i]);
    before.add(link, v, complex.live_pairs(v));
  }
  return {before.counts(), after.counts()};
}

}  // namespace

bool is_no_less_manifold(TriangleComplex& complex, const ContractionProfile& profile) {
  const std::vector<std::vector<Neighbour>>& faces = profile.nonmanifold.faces;
  const std::vector<Neighbour> merged = merged_star(profile);
  const auto is_near_merged = [&, merged_vertex = profile.pair.a](const Neighbour& neighbour) {
    return neighbour.vertex == merged_vertex || contains(merged, neighbour.vertex);
  };
  const auto hangs_together = [&](const std::vector<Neighbour>& at_neighbour) {
    return std::any_of(at_neighbour.begin(), at_neighbour.end(), is_near_merged);
  };
  if (!std::all_of(faces.begin(), faces.end(), hangs_together)) return false;
  const auto [before, after] = count_defects(complex, profile);
  return std::equal(after.begin(), after.end(), before.begin(), std::less_equal<>());
}

bool opens_closed_manifold(TriangleComplex& complex, const ContractionProfile& profile) {
  constexpr std::array<std::size_t, 4> none{};
  const auto [before, after] = count_defects(complex, profile);
  return before == none && after != none;
}

// Vertices minus edges plus faces. One vertex and the pair's edge go; the two edges to a common neighbour become one;
// lost edges, opposite and coincident faces go.
bool keeps_euler_number(const ContractionProfile& profile) {
  const ContractionProfile::NonmanifoldPlan& nonmanifold = profile.nonmanifold;
  return nonmanifold.common.size() + nonmanifold.lost_edges.size() ==
         profile.opposites.size() + nonmanifold.coincident.size();
}

}  // namespace whittle
