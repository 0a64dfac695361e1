#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <sstream>

#include "meshes.hh"
#include "support/shapes.hh"
#include "support/suites.hh"

namespace whittle::test {
namespace {

using testing::ElementsAre;

struct ColorTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3f;
  using Color = OpenMesh::Vec4f;
  VertexAttributes(OpenMesh::Attributes::Normal | OpenMesh::Attributes::Color | OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using ColorMesh = OpenMesh::TriMesh_ArrayKernelT<ColorTraits>;

TEST(Conversions, RoundTripKeepsEveryBitOfManifoldMeshes) {
  for (const auto& [name, shape] : holdable_meshes()) {
    const IndexedMesh again = to_indexed_mesh(open_mesh<DoubleMesh>(shape));
    EXPECT_EQ(again.positions, shape.positions) << name;
    EXPECT_EQ(again.faces, shape.faces) << name << ": faces, or their first corners, changed";
    EXPECT_TRUE(again.origins.empty()) << name;
  }
}

TEST(Conversions, FloatMeshesRoundOnce) {
  const IndexedMesh shape = noisy_sphere(2, 0.1, 4);
  const IndexedMesh again = geometry_of(open_mesh<FloatMesh>(shape));
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    EXPECT_EQ(again.positions[v], shape.positions[v].cast<float>().cast<double>()) << v;
  }
}

TEST(Conversions, FacesRefusedAreNamedAndNothingIsPrinted) {
  const auto refused = [](const IndexedMesh& shape) {
    DoubleMesh mesh;
    std::vector<Index> result = to_open_mesh(shape, mesh);
    EXPECT_EQ(mesh.n_faces() + result.size(), shape.faces.size());
    EXPECT_EQ(mesh.n_vertices(), shape.positions.size());
    return result;
  };
  const std::ostringstream captured;
  std::streambuf* const standard_error = std::cerr.rdbuf(captured.rdbuf());
  EXPECT_THAT(refused(three_faces_on_an_edge()), ElementsAre(1U, 2U)) << "they run along it in the same direction";
  EXPECT_EQ(refused(bow_tie()).size(), 3U) << "the second closed fan at the common vertex";
  EXPECT_FALSE(refused(moebius(12)).empty()) << "not orientable";
  EXPECT_EQ(refused(with_duplicate_faces(sphere(1), 5)).size(), 5U);
  IndexedMesh degenerate = tetrahedron();
  degenerate.faces.insert(degenerate.faces.begin() + 1, Triangle{0, 2, 2});
  EXPECT_THAT(refused(degenerate), ElementsAre(1U));
  std::cerr.rdbuf(standard_error);
  EXPECT_EQ(captured.str(), "");
  EXPECT_TRUE(omerr().is_enabled()) << "OpenMesh was left silent";
}

TEST(Conversions, DeletedElementsAreLeftOutAndOriginsSayWhoIsWho) {
  ColorMesh mesh;
  ASSERT_TRUE(to_open_mesh(octahedron(), mesh).empty());
  const OpenMesh::VertexHandle gone(2);
  mesh.delete_vertex(gone, false);
  const IndexedMesh rest = to_indexed_mesh(mesh);
  EXPECT_EQ(rest.faces.size(), 4U);
  EXPECT_THAT(rest.origins, ElementsAre(0U, 1U, 3U, 4U, 5U));
  EXPECT_EQ(rest.normals.size(), 5U);
  EXPECT_EQ(rest.colors.size(), 5U);
  for (std::size_t v = 0; v < rest.origins.size(); ++v) {
    EXPECT_EQ(rest.positions[v], octahedron().positions[rest.origins[v]]);
  }
  for (const Triangle& face : rest.faces) {
    for (const Index v : face) EXPECT_LT(v, 5U);
  }
}

TEST(Conversions, NormalsAndColoursGoBothWays) {
  IndexedMesh shape = tetrahedron();
  for (std::size_t v = 0; v < 4; ++v) {
    const auto x = static_cast<float>(v);
    shape.normals.push_back({0.5F * x, -1, 0.25F});
    shape.colors.push_back({0.125F * x, 1, 0, 0.5F});
  }
  ColorMesh mesh;
  ASSERT_TRUE(to_open_mesh(shape, mesh).empty());
  const IndexedMesh again = to_indexed_mesh(mesh);
  EXPECT_EQ(again.normals, shape.normals);
  EXPECT_EQ(again.colors, shape.colors);

  DoubleMesh plain;
  ASSERT_TRUE(to_open_mesh(shape, plain).empty());
  EXPECT_FALSE(plain.has_vertex_colors());
  EXPECT_TRUE(to_indexed_mesh(plain).colors.empty());
}

TEST(Conversions, EveryByteOfAColourComesBack) {
  for (int byte = 0; byte < 256; ++byte) {
    const auto channel = static_cast<unsigned char>(byte);
    const OpenMesh::Vec3uc color(channel, 255, 0);
    EXPECT_EQ(detail::to_mesh_color<OpenMesh::Vec3uc>(detail::from_mesh_color(color)), color) << byte;
  }
  EXPECT_EQ(detail::to_mesh_color<OpenMesh::Vec4uc>(Color{-1, 2, 0.5F, 1}), OpenMesh::Vec4uc(0, 255, 128, 255));
}

TEST(Conversions, WhatTheMeshHeldIsCleared) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(sphere(1));
  ASSERT_TRUE(to_open_mesh(tetrahedron(), mesh).empty());
  EXPECT_EQ(mesh.n_vertices(), 4U);
  EXPECT_EQ(mesh.n_faces(), 4U);
  ASSERT_TRUE(to_open_mesh(IndexedMesh{}, mesh).empty());
  EXPECT_EQ(mesh.n_vertices(), 0U);
  EXPECT_TRUE(to_indexed_mesh(mesh).positions.empty());
}

}  // namespace
}  // namespace whittle::test
