#include "surface/face_neighbors.hh"

namespace whittle {

FaceNeighbors::FaceNeighbors(std::span<const Triangle> faces, const VertexCorners& corners)
    : faces_(faces), corners_(corners), beyond_(faces.size()) {
  for (Index f = 0; f < faces.size(); ++f) {
    for (Index place = 0; place < 3; ++place) {
      Side& side = beyond_[f][place];
      if (side.face != invalid_index) continue;
      side = find_beyond(f, place);
      if (side.face != invalid_index) beyond_[side.face][side.place] = {f, place};
    }
  }
}

Side FaceNeighbors::find_beyond(Index face, Index place) const {
  const Index from = faces_[face][place];
  const Index to = corner_after(faces_[face], place, 1);
  Side found{invalid_index, from == to ? crowded : border};
  for (const Corner& corner : corners_.of(from)) {
    if (corner.face == face) continue;
    const Triangle& other = faces_[corner.face];
    const bool is_next = corner_after(other, corner.place, 1) == to;
    if (!is_next && corner_after(other, corner.place, 2) != to) continue;
    if (found.place != border) return {invalid_index, crowded};
    found = {corner.face, is_next ? corner.place : (corner.place + 2) % 3};
  }
  return found;
}

Side FaceNeighbors::inner_side(Index v, Index w) const {
  for (const auto& [f, place] : corners_.of(v)) {
    const Index last = (place + 2) % 3;
    if (corner_after(faces_[f], place, 1) == w && beyond(f, place).face != invalid_index) return {f, place};
    if (faces_[f][last] == w && beyond(f, last).face != invalid_index) return {f, last};
  }
  return {};
}

Fan FaceNeighbors::fan(Index v) const {
  const std::span<const Corner> corners = corners_.of(v);
  if (corners.empty()) return Fan::none;
  const auto& [f, place] = corners.front();
  const Walk forth = walk_around(v, {f, place});
  if (forth.end.face != invalid_index) return forth.n_faces == corners.size() ? Fan::closed : Fan::none;
  const Walk back = walk_around(v, {f, (place + 2) % 3});
  const bool is_row = forth.end.place == border && back.end.place == border;
  return is_row && forth.n_faces + back.n_faces == corners.size() + 1 ? Fan::open : Fan::none;
}

FaceNeighbors::Walk FaceNeighbors::walk_around(Index v, const Side& start) const {
  Walk walk{1, beyond(start.face, start.place)};
  while (walk.end.face != invalid_index && walk.end.face != start.face && walk.n_faces < corners_.of(v).size()) {
    const auto [face, place] = walk.end;
    walk.end = beyond(face, faces_[face][place] == v ? (place + 2) % 3 : (place + 1) % 3);
    ++walk.n_faces;
  }
  return walk;
}

}  // namespace whittle
