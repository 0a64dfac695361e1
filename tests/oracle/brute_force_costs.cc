#include "oracle/brute_force_costs.hh"

#include <algorithm>
#include <map>
#include <set>

#include "support/face_list.hh"
#include "whittle/engine/formula/edge_length_term.hh"

namespace whittle::test {
namespace {

/// Orders sorted corners as a closed walk: each face's second corner is the next face's first. Empty if they don't form
/// one closed walk.
template <class Corners>
Corners as_ring(const Corners& sorted) {
  Corners ring;
  for (auto face = sorted.begin(); ring.size() < sorted.size();
       face = std::ranges::find(sorted, ring.back().y, [](const auto& c) { return c.x; })) {
    if (face == sorted.end() || (face == sorted.begin() && !ring.empty())) return {};
    ring.push_back(*face);
  }
  const bool is_closed = !ring.empty() && ring.back().y == ring.front().x;
  return is_closed ? ring : Corners{};
}

}  // namespace

CostFacts facts_of(const DecimateOptions& options) {
  switch (options.cost.value_or(Cost::quadric)) {
    case Cost::lindstrom_turk:
      return {6, 110};
    case Cost::memoryless:
      return {5, 60};
    case Cost::midpoint:
      return {1, 75};
    case Cost::quadric:
      break;
  }
  return {isotropic_dimension(options.quadric.weights == Weights::uniform ? 2 : 4, options.isotropy), 75};
}

SurfaceNow::SurfaceNow(std::span<const Vec3> positions, std::span<const Triangle> faces)
    : positions_(positions), vertices_(positions.size()) {
  std::vector<std::vector<Triangle>> faces_at(positions.size());
  for (const Triangle& f : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      vertices_[f[i]].corners.push_back({f[(i + 1) % 3], f[(i + 2) % 3]});
      faces_at[f[i]].push_back(f);
    }
  }
  for (Index v = 0; v < vertices_.size(); ++v) {
    Vertex& vertex = vertices_[v];
    std::ranges::sort(vertex.corners);
    auto ring = as_ring(vertex.corners);
    const bool is_ring = !ring.empty();
    if (is_ring) vertex.corners = std::move(ring);
    const Link link = link_of(v, faces_at[v]);
    vertex.on_border = link.vertices.contains(invalid_index);
    vertex.neighbours.assign(link.vertices.begin(), link.vertices.end());
    if (vertex.on_border) vertex.neighbours.pop_back();  // the cone vertex
    for (const auto& [x, y] : vertex.corners) {
      const Vec3 normal = (positions[x] - positions[v]).cross(positions[y] - positions[v]);
      vertex.volume.normal += normal;
      vertex.volume.squares.a += SymmetricMatrix::outer(normal, 1);
      if (is_ring) vertex.link.add(positions[y] - positions[v]);
    }
    if (is_ring) continue;
    for (const Index w : vertex.neighbours) vertex.link.add(positions[w] - positions[v]);
  }
}

/// The faces of both a and b, in order of the third corner's number.
std::vector<SurfaceNow::Third> SurfaceNow::common_faces(Index a, Index b) const {
  std::vector<Third> thirds;
  for (const auto& [x, y] : vertices_[a].corners) {
    if (x == b) thirds.push_back({y, 1});
    if (y == b) thirds.push_back({x, -1});
  }
  std::ranges::sort(thirds, {}, [](const Third& third) { return std::pair(third.corner, -third.turn); });
  return thirds;
}

/// Sums over the faces of a, then over those of b, without the common faces.
VolumeSums SurfaceNow::volume_of(Index a, Index b) const {
  const Vec3 d = positions_[b] - positions_[a];
  VolumeSums sums = vertices_[a].volume;
  sums += vertices_[b].volume.about(-d);
  for (const auto& [c, turn] : common_faces(a, b)) {
    const Vec3 normal = static_cast<double>(turn) * d.cross(positions_[c] - positions_[a]);
    sums.normal -= normal;
    sums.squares.a += SymmetricMatrix::outer(normal, -1);
  }
  return sums;
}

/// The border edges of a in order of their other ends, then those of b except (a, b).
BorderSums SurfaceNow::border_of(Index a, Index b) const {
  BorderSums sums;
  for (const Index v : {a, b}) {
    for (const Index w : vertices_[v].neighbours) {
      if (v == b && w == a) continue;
      const auto is_at_w = [w](const OtherCorners& corners) { return corners.x == w || corners.y == w; };
      if (std::ranges::count_if(vertices_[v].corners, is_at_w) != 1) continue;
      const bool leaves_v = std::ranges::find_if(vertices_[v].corners, is_at_w)->x == w;
      const Vec3 from = positions_[leaves_v ? v : w] - positions_[a];
      const Vec3 to = positions_[leaves_v ? w : v] - positions_[a];
      sums.add(from, to);
    }
  }
  return sums;
}

/// The neighbours of a, then those of b, without a and b themselves; corners of common faces count once.
NeighbourSums SurfaceNow::neighbours_of(Index a, Index b) const {
  const Vec3 d = positions_[b] - positions_[a];
  std::set<Index> corners;
  for (const Third& third : common_faces(a, b)) corners.insert(third.corner);
  NeighbourSums sums = vertices_[a].link;
  sums += vertices_[b].link.about(-d);
  sums.remove(d);
  sums.remove(Vec3::Zero());
  for (const Index c : corners) sums.remove(positions_[c] - positions_[a]);
  return sums;
}

PairEvaluation SurfaceNow::lindstrom_turk(Index a, Index b, PairConstraint constraint) const {
  LindstromTurk term(volume_of(a, b).lanes(), border_of(a, b), Vec3::Zero(), positions_[b] - positions_[a]);
  if (!term.is_determined()) term.add_neighbours(neighbours_of(a, b).lanes());
  return in_frame(term.evaluate(constraint), positions_[a], positions_[b]);
}

/// The merged vertex has the edges of both, except (a, b). Two edges of a common face become one.
ValenceChange SurfaceNow::valence_change(Index a, Index b) const {
  const auto valence = [&](Index v) { return static_cast<int>(vertices_[v].neighbours.size()); };
  const auto on_border = [&](Index v) { return vertices_[v].on_border; };
  std::set<Index> wings;
  for (const Third& third : common_faces(a, b)) wings.insert(third.corner);
  ValenceChange change;
  for (const Index v : wings) {
    change.add_before(valence(v), on_border(v));
    change.add_after(valence(v) - 1, on_border(v));
  }
  for (const Index v : {a, b}) change.add_before(valence(v), on_border(v));
  change.add_after(valence(a) + valence(b) - 2 - static_cast<int>(wings.size()), on_border(a) || on_border(b));
  return change;
}

}  // namespace whittle::test
