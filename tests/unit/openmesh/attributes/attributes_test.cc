// What vertices and halfedges carry, in PairDecimaterT and in OpenMesh's own decimaters.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <whittle/openmesh/mod_attributes.hh>

#include "support/shapes/shapes.hh"
#include "unit/openmesh/common/decimation.hh"
#include "unit/openmesh/common/meshes.hh"
#include "unit/openmesh/common/modules.hh"
#include "whittle/core/wedges.hh"

namespace whittle::test {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

std::size_t side_of(const DoubleMesh& mesh, FaceHandle f) {
  const Vec3 n = to_vec3(mesh.calc_face_normal(f));
  Eigen::Index axis = 0;
  n.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::size_t>(axis) + (n[axis] > 0 ? 1 : 0);
}

DoubleMesh::Normal axis_normal(std::size_t side) {
  DoubleMesh::Normal normal(0, 0, 0);
  normal[side / 2] = side % 2 == 1 ? 1 : -1;
  return normal;
}

/// A cube whose corners have the texture coordinates of a chart a side, the normals of the sides, and their colours.
DoubleMesh charted_mesh(int n) {
  IndexedMesh shape = tessellated_cube(n);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  mesh.request_halfedge_texcoords2D();
  mesh.request_halfedge_texcoords3D();
  mesh.request_halfedge_normals();
  mesh.request_halfedge_colors();
  for (const FaceHandle f : mesh.faces()) {
    const std::size_t side = side_of(mesh, f);
    for (const HalfedgeHandle h : mesh.fh_range(f)) {
      const auto uv = chart_position(side, to_vec3(mesh.point(mesh.to_vertex_handle(h))));
      mesh.set_texcoord2D(h, {static_cast<float>(uv[0]), static_cast<float>(uv[1])});
      mesh.set_texcoord3D(h, {static_cast<float>(uv[1]), static_cast<float>(uv[0]), static_cast<float>(side)});
      mesh.set_normal(h, axis_normal(side));
      mesh.set_color(h, DoubleMesh::Color(static_cast<unsigned char>(20 * side), 7, 250));
    }
  }
  return mesh;
}

void expect_charts_in_place(const DoubleMesh& mesh, double tolerance, const std::string& context) {
  for (const FaceHandle f : mesh.faces()) {
    if (mesh.calc_face_area(f) < 1e-6) continue;  // it is on no side
    const std::size_t side = side_of(mesh, f);
    for (const HalfedgeHandle h : mesh.fh_range(f)) {
      const auto uv = chart_position(side, to_vec3(mesh.point(mesh.to_vertex_handle(h))));
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(mesh.texcoord2D(h)[i], uv[i], tolerance) << context << ", face " << f.idx();
        EXPECT_NEAR(mesh.texcoord3D(h)[1 - i], uv[i], tolerance) << context;
      }
      EXPECT_EQ(mesh.texcoord3D(h)[2], static_cast<float>(side)) << context;
      EXPECT_NEAR((to_vec3(mesh.normal(h)) - to_vec3(mesh.calc_face_normal(f))).norm(), 0, 1e-3) << context;
      EXPECT_EQ(mesh.color(h), DoubleMesh::Color(static_cast<unsigned char>(20 * side), 7, 250)) << context;
    }
  }
}

std::size_t n_faces_left(const DoubleMesh& mesh) {
  std::size_t n = 0;
  for ([[maybe_unused]] const FaceHandle f : mesh.faces()) ++n;
  return n;
}

class CornerAttributes : public EachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, CornerAttributes, each_driver, driver_name);

TEST_P(CornerAttributes, FollowTheVerticesOnEachSideOfASeam) {
  for (const NamedCost& cost : named_costs()) {
    if (cost.options.cost == Cost::midpoint) continue;  // it rounds the cube off
    DoubleMesh mesh = charted_mesh(8);
    PairDecimaterT<DoubleMesh> decimater(mesh);
    add_cost(decimater, cost.options);
    decimater.set_driver(GetParam());
    ASSERT_TRUE(decimater.initialize());
    for (const std::size_t n : {400U, 150U}) decimater.decimate(DecimateTarget::faces(n));
    EXPECT_LE(n_faces_left(mesh), 150U) << cost.name;
    expect_charts_in_place(mesh, 2e-3, cost.name);
    mesh.garbage_collection();
    expect_charts_in_place(mesh, 2e-3, cost.name + ", after garbage collection");
  }
}

TEST(CornerAttributesOfAMesh, AreItsWedges) {
  const DoubleMesh mesh = charted_mesh(6);
  IndexedMesh shape = geometry_of(mesh);
  add_wedges(mesh, whittle::CornerProperties(mesh), shape);
  EXPECT_EQ(n_wedges(shape), 6U * 7 * 7) << "a chart has a wedge a vertex";
  EXPECT_EQ(seam_edges(shape).size(), 12U * 6);
}

TEST(ModAttributes, KeepsChartsInOpenMeshsDecimater) {
  DoubleMesh mesh = charted_mesh(8);
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  add_module<OpenMesh::Decimater::ModQuadricT<DoubleMesh>>(decimater).unset_max_err();
  add_module<OpenMesh::Decimater::ModNormalFlippingT<DoubleMesh>>(decimater).set_max_normal_deviation(45);
  add_module<ModAttributesT<DoubleMesh>>(decimater);
  mesh.update_face_normals();
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, 150);
  EXPECT_LE(n_faces_left(mesh), 200U);
  expect_charts_in_place(mesh, 1e-4, "stock");
  mesh.garbage_collection();
  expect_charts_in_place(mesh, 1e-4, "after garbage collection");
}

TEST(ModAttributes, BlendsWhereTheVertexMoves) {
  IndexedMesh shape = grid(12, 12);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  mesh.request_halfedge_texcoords2D();
  const auto place = [&](HalfedgeHandle h) { return to_vec3(mesh.point(mesh.to_vertex_handle(h))); };
  for (const HalfedgeHandle h : mesh.halfedges()) {
    mesh.set_texcoord2D(h, {static_cast<float>(place(h).x()), static_cast<float>(place(h).y())});
  }
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  add_module<ModMidpointT<DoubleMesh>>(decimater);
  add_module<ModAttributesT<DoubleMesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate_to(90), 50U);
  for (const FaceHandle f : mesh.faces()) {
    for (const HalfedgeHandle h : mesh.fh_range(f)) {
      EXPECT_NEAR(mesh.texcoord2D(h)[0], place(h).x(), 1e-4);
      EXPECT_NEAR(mesh.texcoord2D(h)[1], place(h).y(), 1e-4);
    }
  }
}

class VertexProperties : public EachDriver {};
INSTANTIATE_TEST_SUITE_P(Drivers, VertexProperties, each_driver, driver_name);

TEST_P(VertexProperties, OfRealNumbersAreBlended) {
  IndexedMesh shape = grid(12, 12);
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  OpenMesh::VProp<double> height(mesh, "height");
  OpenMesh::VProp<OpenMesh::Vec3f> flow(mesh, "flow");
  OpenMesh::VProp<int> number(mesh, "number");
  OpenMesh::VProp<double> unnamed(mesh);
  for (const VertexHandle v : mesh.vertices()) {
    const Vec3 p = to_vec3(mesh.point(v));
    height[v] = 2 * p.x() - p.y();
    flow[v] = {static_cast<float>(p.y()), 1, 0};
    number[v] = v.idx();
    unnamed[v] = v.idx();
  }
  PairDecimaterT<DoubleMesh> decimater(mesh);
  add_module<ModMidpointT<DoubleMesh>>(decimater);
  decimater.set_driver(GetParam());
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate_to(90), 50U);
  for (const VertexHandle v : mesh.vertices()) {
    const Vec3 p = to_vec3(mesh.point(v));
    EXPECT_NEAR(height[v], 2 * p.x() - p.y(), 1e-6);
    EXPECT_NEAR(flow[v][0], p.y(), 1e-4);
    EXPECT_EQ(number[v], v.idx());
    EXPECT_EQ(unnamed[v], v.idx()) << "may be a module's";
  }
}

/// The largest error of a property that is linear in the position, on a curved surface, over its range.
double linear_error(const DoubleMesh& mesh, const OpenMesh::VProp<double>& height) {
  double largest = 0;
  for (const VertexHandle v : mesh.vertices()) {
    const Vec3 p = to_vec3(mesh.point(v));
    largest = std::max(largest, std::abs(height[v] - (2 * p.x() - p.y() + p.z())));
  }
  return largest;
}

void set_linear(const DoubleMesh& mesh, OpenMesh::VProp<double>& height) {
  for (const VertexHandle v : mesh.vertices()) {
    const Vec3 p = to_vec3(mesh.point(v));
    height[v] = 2 * p.x() - p.y() + p.z();
  }
}

/// Places of least cost are beside the edges, and beside the surface.
TEST_P(VertexProperties, StayLinearInThePosition) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(blob(4, 1));
  OpenMesh::VProp<double> height(mesh, "height");
  set_linear(mesh, height);
  PairDecimaterT<DoubleMesh> decimater(mesh);
  add_module<ModMemorylessT<DoubleMesh>>(decimater);
  decimater.set_driver(GetParam());
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate_to_faces(0, 500), 1000U);
  EXPECT_LT(linear_error(mesh, height), 0.01);
}

TEST(VertexPropertiesInOpenMesh, StayLinearInThePosition) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(blob(4, 1));
  OpenMesh::VProp<double> height(mesh, "height");
  set_linear(mesh, height);
  OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
  add_module<ModMemorylessT<DoubleMesh>>(decimater);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate_to_faces(0, 500), 1000U);
  EXPECT_LT(linear_error(mesh, height), 0.01);
}

TEST(VertexAttributesOfAMesh, NoticeNewProperties) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(single_triangle());
  const whittle::VertexProperties attributes(mesh);
  EXPECT_TRUE(attributes.empty() && attributes.fits(mesh));
  const OpenMesh::VProp<float> height(mesh, "height");
  EXPECT_FALSE(attributes.fits(mesh));
  EXPECT_FALSE(whittle::VertexProperties(mesh).empty());
}

}  // namespace
}  // namespace whittle::test
