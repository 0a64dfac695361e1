#include "unwrapped_mesh.hh"

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "whittle/core/frame.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/wedges.hh"

namespace whittle::bake {

namespace {

using Normal = std::array<float, 3>;

/// With a sign of 1: rows go down, and the fronts of a chart show, so up is the product of normal and tangent.
std::array<double, 4> tangent_along(const Vec3& right, const Normal& normal) {
  const Vec3 n(normal[0], normal[1], normal[2]);
  Vec3 tangent = right - n.dot(right) * n;
  tangent = tangent.norm() > 1e-6 ? tangent.normalized() : n.unitOrthogonal();
  return {tangent.x(), tangent.y(), tangent.z(), 1};
}

/// Leaves positions, faces and normals, each vertex with as few wedges as these take.
void keep_normals(IndexedMesh& mesh) {
  mesh.colors.clear();
  mesh.attributes.clear();
  const auto of_vertices = vertex_normals(mesh, Frame::of_points(mesh.positions));
  if (mesh.normals.empty()) {
    mesh.wedges.clear();
    mesh.normals = of_vertices;
    return;
  }
  for (std::size_t corner = 0; corner < 3 * mesh.faces.size(); ++corner) {
    Normal& normal = mesh.normals[mesh.wedge(corner / 3, corner % 3)];
    if (normal == Normal{}) normal = of_vertices[mesh.faces[corner / 3][corner % 3]];
  }
  join_equal_wedges(mesh);
}

}  // namespace

IndexedMesh unwrapped_mesh(IndexedMesh mesh, const Unwrapping& layout, bool has_tangents) {
  keep_normals(mesh);
  IndexedMesh result = without_attributes(mesh);
  Attribute texcoords{.name = "TEXCOORD_0", .kind = AttributeKind::texcoord, .n_components = 2};
  Attribute tangents{.name = "TANGENT", .kind = AttributeKind::tangent, .n_components = 4};
  std::map<std::pair<Index, Index>, Index> wedges;  // by chart, and by wedge of the mesh
  result.wedges.reserve(3 * mesh.faces.size());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index of_normal = mesh.wedge(f, k);
      const auto number = static_cast<Index>(wedges.size());
      const auto [wedge, is_new] = wedges.try_emplace({layout.charts[f], of_normal}, number);
      result.wedges.push_back(wedge->second);
      if (!is_new) continue;
      result.normals.push_back(mesh.normals[of_normal]);
      const Eigen::Vector2d& texcoord = layout.texcoords[3 * f + k];
      texcoords.values.insert(texcoords.values.end(), {texcoord.x(), texcoord.y()});
      const std::array<double, 4> tangent = tangent_along(layout.right[layout.charts[f]], mesh.normals[of_normal]);
      tangents.values.insert(tangents.values.end(), tangent.begin(), tangent.end());
    }
  }
  result.attributes.push_back(std::move(texcoords));
  if (has_tangents) result.attributes.push_back(std::move(tangents));
  return result;
}

}  // namespace whittle::bake
