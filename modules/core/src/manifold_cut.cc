#include "whittle/core/manifold_cut.hh"

#include <stdexcept>

#include "whittle/core/detail/edge_table.hh"

namespace whittle {
namespace {

using detail::next_in_face;
using detail::previous_in_face;

/// Calls `use(corner)` for every corner of the fan that `start` is in. A corner has the number of the side that starts
/// there.
template <class Use>
void walk_fan(Index start, const std::vector<Index>& opposite, const Use& use) {
  Index corner = start;
  do {
    use(corner);
    const Index across = opposite[corner];
    if (across == invalid_index) break;
    corner = next_in_face(across);
  } while (corner != start);
  if (opposite[corner] != invalid_index) return;  // closed
  corner = opposite[previous_in_face(start)];
  while (corner != invalid_index) {
    use(corner);
    corner = opposite[previous_in_face(corner)];
  }
}

}  // namespace

std::vector<Index> opposite_sides(std::size_t n_vertices, std::span<const Triangle> faces) {
  const detail::EdgeTable edges(faces, n_vertices);
  std::vector<Index> opposite(3 * faces.size(), invalid_index);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    if (!edges.is_regular(edge, faces)) continue;
    const std::span<const Index> sides = edges.sides(edge);
    opposite[sides[0]] = sides[1];
    opposite[sides[1]] = sides[0];
  }
  return opposite;
}

ManifoldCut cut_into_manifold(std::size_t n_vertices, std::span<const Triangle> faces) {
  const std::vector<Index> opposite = opposite_sides(n_vertices, faces);
  ManifoldCut cut{{faces.begin(), faces.end()}, {}};
  std::vector<bool> is_taken(n_vertices);
  std::vector<bool> is_done(opposite.size());
  const auto new_number = [&](Index original) {
    if (!is_taken[original]) {
      is_taken[original] = true;
      return original;
    }
    const std::size_t number = n_vertices + cut.originals.size();
    if (number >= invalid_index) throw std::length_error("cut_into_manifold: too many vertices");
    cut.originals.push_back(original);
    return static_cast<Index>(number);
  };
  for (Index corner = 0; corner < opposite.size(); ++corner) {
    const Triangle& face = faces[corner / 3];
    if (is_done[corner] || !has_three_corners(face)) continue;
    const Index number = new_number(face[corner % 3]);
    walk_fan(corner, opposite, [&](Index reached) {
      is_done[reached] = true;
      cut.faces[reached / 3][reached % 3] = number;
    });
  }
  return cut;
}

}  // namespace whittle
