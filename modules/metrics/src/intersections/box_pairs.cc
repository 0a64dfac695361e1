#include "intersections/box_pairs.hh"

#include <utility>

namespace whittle::metrics {

BoxPairs::BoxPairs(std::vector<FaceBox> boxes) : boxes_(std::move(boxes)) {
  if (boxes_.empty()) return;
  depth_ = static_cast<unsigned>(std::bit_width((boxes_.size() - 1) / most_in_a_leaf));
  nodes_.resize((std::size_t{2} << depth_) - 1);
  build(0, 0, boxes_.size());
}

void BoxPairs::build(std::size_t node, std::size_t begin, std::size_t end) {
  if (is_leaf(node)) {
    FaceBox around = boxes_[begin];
    for (std::size_t i = begin + 1; i < end; ++i) {
      around.min = around.min.cwiseMin(boxes_[i].min);
      around.max = around.max.cwiseMax(boxes_[i].max);
    }
    nodes_[node] = {around, begin, end};
    return;
  }
  // Twice the centers, as that is all the same.
  Vec3 least = boxes_[begin].min + boxes_[begin].max;
  Vec3 most = least;
  for (std::size_t i = begin + 1; i < end; ++i) {
    const Vec3 center = boxes_[i].min + boxes_[i].max;
    least = least.cwiseMin(center);
    most = most.cwiseMax(center);
  }
  Eigen::Index axis = 0;
  (most - least).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) { return boxes_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [axis](const FaceBox& a, const FaceBox& b) {
    return a.min[axis] + a.max[axis] < b.min[axis] + b.max[axis];
  });
  build(2 * node + 1, begin, middle);
  build(2 * node + 2, middle, end);
  FaceBox around = nodes_[2 * node + 1].box;
  around.min = around.min.cwiseMin(nodes_[2 * node + 2].box.min);
  around.max = around.max.cwiseMax(nodes_[2 * node + 2].box.max);
  nodes_[node] = {around, begin, end};
}

}  // namespace whittle::metrics
