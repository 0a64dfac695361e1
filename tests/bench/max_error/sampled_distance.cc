#include "bench/max_error/sampled_distance.hh"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "support/brute_distance.hh"
#include "support/random.hh"

namespace whittle::bench {
namespace {

constexpr std::size_t most_faces_of_a_leaf = 4;

Vec3 center_of(const IndexedMesh& mesh, Index f) {
  const auto& [a, b, c] = test::corners_of(mesh, f);
  return (a + b + c) / 3;
}

double area_of_face(const IndexedMesh& mesh, Index f) {
  const auto& [a, b, c] = test::corners_of(mesh, f);
  return 0.5 * (b - a).cross(c - a).norm();
}

double distance_to_box(const Vec3& low, const Vec3& high, const Vec3& p) {
  return (low - p).cwiseMax(p - high).cwiseMax(0).norm();
}

}  // namespace

FaceTree::FaceTree(const IndexedMesh& mesh) : mesh_(mesh), faces_(mesh.faces.size()) {
  std::iota(faces_.begin(), faces_.end(), Index{0});
  build(0, faces_.size());
}

void FaceTree::build(std::size_t begin, std::size_t end) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Node node{Vec3::Constant(infinity), Vec3::Constant(-infinity), begin, end};
  for (std::size_t i = begin; i < end; ++i) {
    for (const Vec3& corner : test::corners_of(mesh_, faces_[i])) {
      node.low = node.low.cwiseMin(corner);
      node.high = node.high.cwiseMax(corner);
    }
  }
  const std::size_t number = nodes_.size();
  nodes_.push_back(node);
  if (end - begin <= most_faces_of_a_leaf) return;
  int axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) { return faces_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [&](Index f, Index g) { return center_of(mesh_, f)[axis] < center_of(mesh_, g)[axis]; });
  build(begin, middle);
  nodes_[number].second_child = nodes_.size();
  build(middle, end);
}

double FaceTree::distance(const Vec3& point) const {
  double distance = std::numeric_limits<double>::infinity();
  lessen(distance, point, 0);
  return distance;
}

void FaceTree::lessen(double& distance, const Vec3& point, std::size_t number) const {
  const Node& node = nodes_[number];
  if (node.second_child == 0) {
    for (std::size_t i = node.begin; i < node.end; ++i)
      distance = std::min(distance, test::distance_to_triangle(test::corners_of(mesh_, faces_[i]), point));
    return;
  }
  std::pair<double, std::size_t> children[2];
  std::size_t child = number + 1;
  for (auto& [to_box, of_child] : children) {
    to_box = distance_to_box(nodes_[child].low, nodes_[child].high, point);
    of_child = std::exchange(child, node.second_child);
  }
  if (children[1] < children[0]) std::swap(children[0], children[1]);
  for (const auto& [to_box, of_child] : children)
    if (to_box < distance) lessen(distance, point, of_child);
}

double sampled_distance(const IndexedMesh& from, const FaceTree& to, std::size_t n_samples, std::uint64_t seed) {
  double area = 0;
  for (Index f = 0; f < from.faces.size(); ++f) area += area_of_face(from, f);
  test::Random random(seed);
  std::vector<bool> is_measured(from.positions.size());
  double largest = 0;
  for (Index f = 0; f < from.faces.size(); ++f) {
    for (const Index v : from.faces[f]) {
      if (!is_measured[v]) largest = std::max(largest, to.distance(from.positions[v]));
      is_measured[v] = true;
    }
    const auto& [a, b, c] = test::corners_of(from, f);
    const double share = area > 0 ? area_of_face(from, f) / area : 0;
    for (double left = std::max(1.0, share * static_cast<double>(n_samples)); left >= random.uniform(); --left) {
      const double u = std::sqrt(random.uniform());
      const double v = random.uniform();
      largest = std::max(largest, to.distance((1 - u) * a + u * (1 - v) * b + u * v * c));
    }
  }
  return largest;
}

IndexedMesh border_as_faces(const IndexedMesh& mesh) {
  std::map<std::pair<Index, Index>, int> n_faces;
  for (const Triangle& face : mesh.faces) {
    if (!has_three_corners(face)) continue;
    for (std::size_t i = 0; i < 3; ++i) ++n_faces[std::minmax(face[i], face[(i + 1) % 3])];
  }
  IndexedMesh border;
  border.positions = mesh.positions;
  for (const auto& [edge, n] : n_faces)
    if (n == 1) border.faces.push_back({edge.first, edge.second, edge.second});
  return border;
}

}  // namespace whittle::bench
