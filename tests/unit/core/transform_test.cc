#include "whittle/core/transform.hh"

#include <gtest/gtest.h>

#include <cmath>

namespace whittle::test {
namespace {

/// A triangle with a normal of its own, a tangent along its first edge, and a morph target.
IndexedMesh dressed_triangle() {
  IndexedMesh mesh;
  mesh.positions = {{1, 0, 0}, {2, 0, 1}, {1, 3, 0}};
  mesh.faces = {{0, 1, 2}};
  const Vec3 normal = Vec3(1, 0, 1).cross(Vec3(0, 3, 0)).normalized();
  mesh.normals.assign(3,
                      {static_cast<float>(normal.x()), static_cast<float>(normal.y()), static_cast<float>(normal.z())});
  const double half = std::sqrt(0.5);
  mesh.attributes = {
      {.name = "TANGENT",
       .kind = AttributeKind::tangent,
       .n_components = 4,
       .values = {half, 0, half, 1, half, 0, half, 1, half, 0, half, 1}},
      {.name = "target 0 POSITION",
       .kind = AttributeKind::displacement,
       .n_components = 3,
       .values = {0, 0, 0, 0, 2, 0, 1, 1, 1}},
      {.name = "target 0 NORMAL",
       .kind = AttributeKind::direction,
       .n_components = 3,
       .values = {0, 0, 0, 0.5, 0, 0, 0, 0.25, 0}},
      {.name = "TEXCOORD_0", .kind = AttributeKind::texcoord, .n_components = 2, .values = {0, 0, 1, 0, 0, 1}}};
  return mesh;
}

Vec3 vector_of(const Attribute& attribute, std::size_t i) { return Vec3(attribute.value(i).data()); }
Vec3 vector_of(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }

Vec3 face_normal(const IndexedMesh& mesh) {
  const auto [a, b, c] = mesh.faces[0];
  const Vec3 edge = mesh.positions[b] - mesh.positions[a];
  return edge.cross(mesh.positions[c] - mesh.positions[a]).normalized();
}

/// One that turns, one that stretches, one that mirrors.
std::vector<Eigen::Affine3d> maps() {
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 3).normalized());
  return {Eigen::Translation3d(5, 6, 7) * turn * Eigen::Scaling(2.0), turn * Eigen::Scaling(0.5, 3.0, 20.0),
          Eigen::Translation3d(0, 0, 1e3) * turn * Eigen::Scaling(-1.0, 2.0, 1.0)};
}

TEST(TransformMesh, KeepsNormalsUprightAndTangentsFlat) {
  for (const Eigen::Affine3d& map : maps()) {
    const IndexedMesh before = dressed_triangle();
    IndexedMesh mesh = before;
    transform_mesh(mesh, map);
    const Vec3 bitangent = vector_of(before.normals[0]).cross(vector_of(before.attributes[0], 0));
    for (std::size_t v = 0; v < 3; ++v) {
      EXPECT_EQ(mesh.positions[v], map * before.positions[v]);
      EXPECT_NEAR((vector_of(mesh.normals[v]) - face_normal(mesh)).norm(), 0, 1e-6) << "fronts stay fronts";
      const Attribute& tangents = mesh.attributes[0];
      EXPECT_NEAR(vector_of(tangents, v).norm(), 1, 1e-12);
      EXPECT_NEAR(vector_of(tangents, v).dot(face_normal(mesh)), 0, 1e-12);
      const Vec3 side = vector_of(mesh.normals[v]).cross(vector_of(tangents, v)) * tangents.value(v)[3];
      EXPECT_GT(side.dot(map.linear() * bitangent), 0) << "the bitangent moves along";
      const Vec3 moved = before.positions[v] + vector_of(before.attributes[1], v);
      EXPECT_NEAR((mesh.positions[v] + vector_of(mesh.attributes[1], v) - map * moved).norm(), 0, 1e-12);
    }
    EXPECT_EQ(mesh.attributes[3].values, before.attributes[3].values);
  }
}

TEST(TransformMesh, TurnsWhatIsAddedToNormalsAsIfNothingWereStretched) {
  IndexedMesh mesh = dressed_triangle();
  transform_mesh(mesh, maps()[0]);
  EXPECT_NEAR(vector_of(mesh.attributes[2], 1).norm(), 0.5, 1e-12);
}

TEST(TransformMesh, IsUndoneByTheInverse) {
  for (const Eigen::Affine3d& map : maps()) {
    const IndexedMesh before = dressed_triangle();
    IndexedMesh mesh = before;
    transform_mesh(mesh, map);
    transform_mesh(mesh, map.inverse());
    EXPECT_EQ(mesh.faces, before.faces);
    for (std::size_t v = 0; v < 3; ++v) {
      EXPECT_NEAR((mesh.positions[v] - before.positions[v]).norm(), 0, 1e-12);
      EXPECT_NEAR((vector_of(mesh.normals[v]) - vector_of(before.normals[v])).norm(), 0, 1e-6);
    }
    for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
      for (std::size_t k = 0; k < mesh.attributes[i].values.size(); ++k) {
        EXPECT_NEAR(mesh.attributes[i].values[k], before.attributes[i].values[k], 1e-12) << mesh.attributes[i].name;
      }
    }
  }
}

TEST(TransformMesh, TakesMapsThatFlatten) {
  IndexedMesh mesh = dressed_triangle();
  mesh.normals[1] = {0, 0, 0};
  transform_mesh(mesh, Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, 0.0)));
  EXPECT_EQ(vector_of(mesh.normals[0]), face_normal(mesh));
  EXPECT_EQ(vector_of(mesh.normals[1]), Vec3(0, 0, 0));
  for (const Attribute& attribute : mesh.attributes) {
    for (const double value : attribute.values) EXPECT_TRUE(std::isfinite(value)) << attribute.name;
  }
}

}  // namespace
}  // namespace whittle::test
