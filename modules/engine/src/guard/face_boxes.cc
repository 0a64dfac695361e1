#include "guard/face_boxes.hh"

#include <algorithm>
#include <bit>

namespace whittle {

FaceBoxes::FaceBoxes(TriangleComplex& complex)
    : complex_(complex),
      n_leaves_(std::bit_ceil(std::max<std::size_t>(complex.n_vertex_slots(), 1))),
      nodes_(2 * n_leaves_) {
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) nodes_[n_leaves_ + v] = box_of_own_faces(v);
  for (std::size_t node = n_leaves_ - 1; node > 0; --node) nodes_[node] = nodes_[2 * node].merged(nodes_[2 * node + 1]);
}

void FaceBoxes::update(Index v) {
  std::size_t node = n_leaves_ + v;
  nodes_[node] = box_of_own_faces(v);
  for (node /= 2; node > 0; node /= 2) {
    const FloatBox merged = nodes_[2 * node].merged(nodes_[2 * node + 1]);
    if (merged.min() == nodes_[node].min() && merged.max() == nodes_[node].max()) return;
    nodes_[node] = merged;
  }
}

FloatBox FaceBoxes::box_of_own_faces(Index v) const {
  FloatBox box;
  if (complex_.representative(v) != v) return box;
  const std::span<const Neighbour> pairs = complex_.live_pairs(v);
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    if (pairs[i].vertex < v || pairs[i + 1].vertex < v) continue;
    box.extend(complex_.position(pairs[i].vertex).cast<float>());
    box.extend(complex_.position(pairs[i + 1].vertex).cast<float>());
  }
  if (!box.isEmpty()) box.extend(complex_.position(v).cast<float>());
  return box;
}

}  // namespace whittle
