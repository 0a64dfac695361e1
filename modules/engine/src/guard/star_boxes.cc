#include "guard/star_boxes.hh"

#include <algorithm>
#include <bit>

namespace whittle {

StarBoxes::StarBoxes(TriangleComplex& complex)
    : complex_(complex),
      n_leaves_(std::bit_ceil(std::max<std::size_t>(complex.n_vertex_slots(), 1))),
      nodes_(2 * n_leaves_) {
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) nodes_[n_leaves_ + v] = box_of_star(v);
  for (std::size_t node = n_leaves_ - 1; node > 0; --node) nodes_[node] = nodes_[2 * node].merged(nodes_[2 * node + 1]);
}

void StarBoxes::update(Index v) {
  std::size_t node = n_leaves_ + v;
  nodes_[node] = box_of_star(v);
  for (node /= 2; node > 0; node /= 2) {
    const StarBox merged = nodes_[2 * node].merged(nodes_[2 * node + 1]);
    if (merged.min() == nodes_[node].min() && merged.max() == nodes_[node].max()) return;
    nodes_[node] = merged;
  }
}

StarBox StarBoxes::box_of_star(Index v) const {
  StarBox box;
  if (complex_.representative(v) != v) return box;
  for (const Neighbour& neighbour : complex_.live_pairs(v)) {
    box.extend(complex_.position(neighbour.vertex).cast<float>());
  }
  if (!box.isEmpty()) box.extend(complex_.position(v).cast<float>());
  return box;
}

}  // namespace whittle
