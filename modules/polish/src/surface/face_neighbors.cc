#include "surface/face_neighbors.hh"

#include <algorithm>

namespace whittle::polishing {

FaceNeighbors::FaceNeighbors(std::span<const Triangle> faces, const VertexCorners& corners,
                             const detail::Workers& workers)
    : faces_(faces), corners_(corners) {
  constexpr Side unknown{invalid_index, crowded};
  beyond_.assign(faces.size(), {unknown, unknown, unknown});
  for_each_range(corners.size(), workers, [this](std::size_t begin, std::size_t end) {
    std::vector<EdgeSide> sides;
    for (auto v = static_cast<Index>(begin); v < end; ++v) connect_at(v, sides);
  });
}

/// Finds the neighbours beyond the edges at v to higher vertices. \param sides scratch
void FaceNeighbors::connect_at(Index v, std::vector<EdgeSide>& sides) {
  sides.clear();
  for (const auto& [f, slot] : corners_.of(v)) {
    if (!has_three_corners(faces_[f])) continue;
    const Index next = corner_after(faces_[f], slot, 1);
    const Index last = corner_after(faces_[f], slot, 2);
    if (next > v) sides.push_back({next, {f, slot}});
    if (last > v) sides.push_back({last, {f, (slot + 2) % 3}});
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& x, const EdgeSide& y) { return x.vertex < y.vertex; });
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].vertex == sides[begin].vertex) ++end;
    if (end - begin > 2) continue;
    const Side& first = sides[begin].side;
    const Side& last = sides[end - 1].side;
    const bool is_border = end - begin == 1;
    beyond_[first.face][first.slot] = is_border ? Side{invalid_index, border} : last;
    if (!is_border) beyond_[last.face][last.slot] = first;
  }
}

Side FaceNeighbors::inner_side(Index v, Index w) const {
  for (const auto& [f, slot] : corners_.of(v)) {
    const Index last = (slot + 2) % 3;
    if (corner_after(faces_[f], slot, 1) == w && beyond(f, slot).face != invalid_index) return {f, slot};
    if (faces_[f][last] == w && beyond(f, last).face != invalid_index) return {f, last};
  }
  return {};
}

Fan FaceNeighbors::fan(Index v) const {
  const std::span<const Corner> corners = corners_.of(v);
  if (corners.empty()) return Fan::none;
  const auto& [f, slot] = corners.front();
  const Walk forth = walk_around(v, {f, slot});
  if (forth.end.face != invalid_index) return forth.n_faces == corners.size() ? Fan::closed : Fan::none;
  const Walk back = walk_around(v, {f, (slot + 2) % 3});
  const bool is_row = forth.end.slot == border && back.end.slot == border;
  return is_row && forth.n_faces + back.n_faces == corners.size() + 1 ? Fan::open : Fan::none;
}

FaceNeighbors::Walk FaceNeighbors::walk_around(Index v, const Side& start) const {
  Walk walk{1, beyond(start.face, start.slot)};
  while (walk.end.face != invalid_index && walk.end.face != start.face && walk.n_faces < corners_.of(v).size()) {
    const auto [face, slot] = walk.end;
    walk.end = beyond(face, faces_[face][slot] == v ? (slot + 2) % 3 : (slot + 1) % 3);
    ++walk.n_faces;
  }
  return walk;
}

}  // namespace whittle::polishing
