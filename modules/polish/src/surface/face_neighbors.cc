#include "surface/face_neighbors.hh"

#include "whittle/core/detail/edge_table.hh"

namespace whittle::polishing {

FaceNeighbors::FaceNeighbors(std::span<const Triangle> faces, const VertexCorners& corners)
    : faces_(faces), corners_(corners) {
  constexpr Side nothing{invalid_index, crowded};
  beyond_.assign(faces.size(), {nothing, nothing, nothing});
  const auto at = [this](Index side) -> Side& { return beyond_[side / 3][side % 3]; };
  const detail::EdgeTable edges(faces, corners.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> sides = edges.sides(e);
    if (sides.size() == 1) at(sides[0]).slot = border;
    if (sides.size() != 2) continue;
    at(sides[0]) = {sides[1] / 3, sides[1] % 3};
    at(sides[1]) = {sides[0] / 3, sides[0] % 3};
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
