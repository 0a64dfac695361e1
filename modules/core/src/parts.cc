#include "whittle/core/parts.hh"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/detail/disjoint_sets.hh"
#include "whittle/core/detail/drop.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/wedges.hh"

namespace whittle {

Parts find_parts(std::size_t n_vertices, std::span<const Triangle> faces) {
  detail::DisjointSets<Index> sets(n_vertices);
  Parts parts;
  parts.part_of.assign(n_vertices, invalid_index);
  for (const Triangle& face : faces) {
    if (!has_three_corners(face)) continue;
    sets.join(face[0], face[1]);
    sets.join(face[0], face[2]);
    for (const Index v : face) parts.part_of[v] = 0;
  }
  for (Index v = 0; v < n_vertices; ++v) {
    if (parts.part_of[v] == invalid_index) continue;
    const Index lowest = sets.find(v);
    parts.part_of[v] = lowest == v ? static_cast<Index>(parts.count++) : parts.part_of[lowest];
  }
  return parts;
}

std::vector<double> part_diagonals(std::span<const Vec3> positions, const Parts& parts) {
  std::vector<Box> boxes(parts.count);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (parts.part_of[v] != invalid_index) boxes[parts.part_of[v]].extend(positions[v]);
  }
  std::vector<double> diagonals(boxes.size());
  std::transform(boxes.begin(), boxes.end(), diagonals.begin(), [](const Box& box) { return diagonal_of(box); });
  return diagonals;
}

PrunedMesh without_small_parts(IndexedMesh mesh, double size) {
  if (!(size >= 0)) throw std::invalid_argument("without_small_parts: the size is negative or not a number");
  check_corners(mesh.positions.size(), mesh.faces);
  const Parts parts = find_parts(mesh.positions.size(), mesh.faces);
  const std::vector<double> diagonals = part_diagonals(mesh.positions, parts);
  const auto is_dropped = [&](std::size_t v) {
    return parts.part_of[v] != invalid_index && diagonals[parts.part_of[v]] < size;
  };
  const bool has_wedges = !mesh.wedges.empty();
  PrunedMesh result;
  result.mesh = std::move(mesh);
  const auto is_small = [&](double diagonal) { return diagonal < size; };
  result.n_dropped_parts = static_cast<std::size_t>(std::count_if(diagonals.begin(), diagonals.end(), is_small));
  // Any corner: the corners of a degenerate face may be in different parts.
  result.n_dropped_faces = drop_faces(result.mesh, [&](std::size_t f) {
    const Triangle& face = result.mesh.faces[f];
    return std::any_of(face.begin(), face.end(), is_dropped);
  });
  result.vertex_map = drop_vertices(result.mesh, is_dropped);
  if (has_wedges && result.mesh.faces.empty()) gather_wedges(result.mesh, {});
  join_equal_wedges(result.mesh);  // drops wedges of dropped faces
  return result;
}

}  // namespace whittle
