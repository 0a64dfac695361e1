#include "attributes/region_trees.hh"

#include <algorithm>

namespace whittle {
namespace {

/// \pre the point is on the face
std::array<double, 3> barycentric(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area_sq = normal.squaredNorm();
  if (area_sq > 0) {
    const double of_b = (point - a).cross(c - a).dot(normal) / area_sq;
    const double of_c = (b - a).cross(point - a).dot(normal) / area_sq;
    const double second = std::clamp(of_b, 0.0, 1.0);
    const double third = std::clamp(of_c, 0.0, 1.0 - second);
    return {1 - second - third, second, third};
  }
  // A face without area: the nearest corner.
  const std::array<double, 3> distances{(point - a).squaredNorm(), (point - b).squaredNorm(),
                                        (point - c).squaredNorm()};
  std::array<double, 3> weights{};
  weights[static_cast<std::size_t>(std::min_element(distances.begin(), distances.end()) - distances.begin())] = 1;
  return weights;
}

/// Some faces, with the vertices that they have.
IndexedMesh part_of(const IndexedMesh& mesh, std::span<const Index> faces) {
  IndexedMesh part;
  std::unordered_map<Index, Index> numbers;
  for (const Index f : faces) {
    Triangle& face = part.faces.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index v = mesh.faces[f][k];
      const auto [found, is_new] = numbers.try_emplace(v, static_cast<Index>(part.positions.size()));
      if (is_new) part.positions.push_back(mesh.positions[v]);
      face[k] = found->second;
    }
  }
  return part;
}

}  // namespace

RegionTrees::RegionTrees(const IndexedMesh& mesh, std::span<const Index> regions)
    : mesh_(mesh), places_(regions.size()), regions_(regions.begin(), regions.end()) {
  std::vector<std::vector<Index>> faces;
  for (Index f = 0; f < regions.size(); ++f) {
    const auto [found, is_new] = part_of_region_.try_emplace(regions[f], faces.size());
    if (is_new) faces.emplace_back();
    places_[f] = static_cast<Index>(faces[found->second].size());
    faces[found->second].push_back(f);
  }
  parts_.reserve(faces.size());
  for (std::vector<Index>& of_part : faces) {
    metrics::TriangleTree tree(part_of(mesh, of_part));
    parts_.push_back({std::move(of_part), std::move(tree)});
  }
}

RegionTrees::Foot RegionTrees::nearest(Index region, const Vec3& point, const Foot& hint) const {
  const auto found = part_of_region_.find(region);
  if (found == part_of_region_.end()) return {};
  const Part& part = parts_[found->second];
  const bool is_hint = hint.face != invalid_index && regions_[hint.face] == region;
  const metrics::ClosestPoint closest = part.tree.nearest(point, is_hint ? places_[hint.face] : invalid_index);
  const Index f = part.faces[closest.face];
  const auto& [a, b, c] = mesh_.faces[f];
  return {f, barycentric(mesh_.positions[a], mesh_.positions[b], mesh_.positions[c], closest.point)};
}

}  // namespace whittle
