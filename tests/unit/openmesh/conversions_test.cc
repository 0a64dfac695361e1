#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>
#include <whittle/io/read.hh>

#include "common/meshes.hh"
#include "support/meshes.hh"
#include "support/shapes/shapes.hh"
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
    std::vector<Index> result = to_open_mesh(shape, mesh, NonManifold::refuse);
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

// Cut into copies ----------------------------------------------------------------------------------------------------

std::vector<NamedMesh> odd_meshes() {
  std::vector<NamedMesh> result = nonmanifold_meshes();
  const auto add = [&result](std::string name, IndexedMesh mesh) {
    result.push_back({std::move(name), std::move(mesh)});
  };
  add("two cubes on an edge of four pieces", two_cubes_on_an_edge(4));
  add("pillow", pillow());
  add("soup", soup(icosahedron()));
  add("glued soup", glued(soup(icosahedron())));
  add("moebius", moebius(12));
  add("every face doubled", with_duplicate_faces(cube(), 12));
  add("every face doubled, back to back", glued(joined(cube(), inside_out(cube()))));
  IndexedMesh mixed = noisy_grid(7, 6, 0.2, 3);
  for (std::size_t f = 0; f < mixed.faces.size(); f += 3) std::swap(mixed.faces[f][0], mixed.faces[f][1]);
  add("mixed orientation", std::move(mixed));
  add("boxes side by side", glued(boxes(3, 3, 0)));
  return result;
}

/// Converts there and back. The result has the same faces in the same order and no additional vertices. The mesh
/// between is manifold.
void expect_round_trip(const IndexedMesh& shape, const std::string& name) {
  ColorMesh mesh;
  ASSERT_THAT(to_open_mesh(shape, mesh), testing::IsEmpty()) << name;
  expect_sound(mesh, name);
  for (const auto v : mesh.vertices()) ASSERT_TRUE(mesh.is_manifold(v)) << name << ": vertex " << v.idx();
  const IndexedMesh again = to_indexed_mesh(mesh);
  EXPECT_EQ(again.positions, shape.positions) << name;
  EXPECT_EQ(again.faces, shape.faces) << name;
  EXPECT_TRUE(again.origins.empty()) << name;

  const IndexedMesh apart = geometry_of(mesh, Copies::apart);
  EXPECT_EQ(apart.positions.size(), mesh.n_vertices()) << name;
  EXPECT_TRUE(topology(apart).manifold()) << name << ": " << topology(apart);
}

TEST(Conversions, RoundTripLosesNoFaceOfAnyMesh) {
  for (const auto& [name, shape] : all_meshes()) {
    expect_round_trip(shape, name);
    expect_round_trip(permuted(shape, 3).mesh, name + ", permuted");
  }
  for (const auto& [name, shape] : odd_meshes()) {
    expect_round_trip(shape, name);
    expect_round_trip(permuted(shape, 3).mesh, name + ", permuted");
  }
}

/// All readable real meshes in a folder, with exact duplicates of vertices welded or not.
std::vector<NamedMesh> readable_meshes(const std::filesystem::path& folder) {
  std::vector<NamedMesh> result;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    for (const bool weld : {true, false}) {
      io::ReadOptions options;
      options.weld = weld;
      try {
        IndexedMesh mesh = io::read_mesh(entry.path(), options).mesh;
        mesh.origins.clear();
        result.push_back({entry.path().string(), std::move(mesh)});
      } catch (const io::ReadError&) {  // other tests cover what reading refuses
        break;
      }
    }
  }
  return result;
}

TEST(Conversions, RoundTripLosesNoFaceOfRealMeshes) {
  for (const char* name : {"nasty", "synthetic"}) {
    const std::filesystem::path folder = std::filesystem::path(WHITTLE_TEST_MESHES) / name;
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no folder " << folder;
    const std::vector<NamedMesh> meshes = readable_meshes(folder);
    EXPECT_GT(meshes.size(), 20U);
    for (const auto& [file, mesh] : meshes) expect_round_trip(mesh, file);
  }
}

TEST(Conversions, RoundTripLosesNoFaceOfALargeNonManifoldMesh) {
  WHITTLE_REAL_MESH_OR_SKIP(file, "dragon_vrip_res3.ply");
  IndexedMesh mesh = io::read_mesh(file).mesh;
  mesh.origins.clear();
  EXPECT_GT(topology(mesh).nonmanifold_edges, 2000);
  expect_round_trip(mesh, file.string());
}

TEST(Conversions, OnlyDegenerateFacesAreLost) {
  IndexedMesh shape = book(3, 2);
  const std::vector<Triangle> faces = shape.faces;
  shape.faces.insert(shape.faces.begin() + 4, Triangle{0, 2, 2});
  shape.faces.push_back({1, 1, 1});
  DoubleMesh mesh;
  EXPECT_THAT(to_open_mesh(shape, mesh), ElementsAre(4U, faces.size() + 1));
  EXPECT_EQ(to_indexed_mesh(mesh).faces, faces);
}

TEST(Conversions, ThePropertySaysWhichCopiesBelongTogether) {
  ColorMesh mesh;
  IndexedMesh shape = book(3, 1);  // the vertices of its spine are 0 and 1
  shape.colors.assign(shape.positions.size(), Color{0, 0, 0, 1});
  shape.colors[1] = {0, 1, 0, 1};
  ASSERT_TRUE(to_open_mesh(shape, mesh).empty());
  ASSERT_EQ(mesh.n_vertices(), shape.positions.size() + 4);
  const auto property = find_copies_property(mesh);
  ASSERT_TRUE(property.is_valid());
  std::map<int, std::vector<int>> copies;
  for (const auto v : mesh.vertices()) {
    if (mesh.property(property, v) != 0) copies[mesh.property(property, v)].push_back(v.idx());
  }
  ASSERT_EQ(copies.size(), 2U);
  for (const auto& [number, vertices] : copies) {
    EXPECT_GT(number, 0);
    ASSERT_EQ(vertices.size(), 3U);
    EXPECT_EQ(vertices[0] + 1, number) << "the first keeps its handle";
    for (const int v : vertices) {
      EXPECT_EQ(mesh.point(OpenMesh::VertexHandle(v)), mesh.point(OpenMesh::VertexHandle(vertices[0])));
      EXPECT_EQ(mesh.color(OpenMesh::VertexHandle(v)), mesh.color(OpenMesh::VertexHandle(vertices[0])));
    }
  }
  mesh.add_vertex({1, 2, 3});
  EXPECT_EQ(mesh.property(property, OpenMesh::VertexHandle(static_cast<int>(mesh.n_vertices()) - 1)), 0);

  DoubleMesh plain;
  ASSERT_TRUE(to_open_mesh(sphere(1), plain).empty());
  EXPECT_FALSE(find_copies_property(plain).is_valid());
  EXPECT_TRUE(first_copies(plain).empty());
}

TEST(Conversions, GarbageCollectionKeepsCopiesTogether) {
  const IndexedMesh shape = two_cubes_on_an_edge(3);
  ColorMesh mesh;
  ASSERT_TRUE(to_open_mesh(shape, mesh).empty());
  mesh.delete_vertex(OpenMesh::VertexHandle(0), true);
  const IndexedMesh before = geometry_of(mesh);
  mesh.garbage_collection();
  const IndexedMesh after = geometry_of(mesh);
  EXPECT_EQ(after.positions.size(), before.positions.size());
  EXPECT_EQ(topology(after), topology(before));
  EXPECT_GT(topology(after).nonmanifold_edges, 0);
}

TEST(Conversions, CopiesMovedApartStayApart) {
  DoubleMesh mesh;
  ASSERT_TRUE(to_open_mesh(book(3, 1), mesh).empty());
  const auto property = find_copies_property(mesh);
  std::vector<OpenMesh::VertexHandle> copies;
  for (const auto v : mesh.vertices()) {
    if (mesh.property(property, v) == 1) copies.push_back(v);
  }
  ASSERT_EQ(copies.size(), 3U);
  const auto expect_joined = [&](const std::vector<Index>& expected) {
    const std::vector<Index> firsts = first_copies(mesh);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(firsts[static_cast<std::size_t>(copies[i].idx())], static_cast<Index>(copies[expected[i]].idx()));
    }
  };
  expect_joined({0, 0, 0});
  mesh.set_point(copies[0], {9, 9, 9});
  expect_joined({0, 1, 1});
  EXPECT_EQ(geometry_of(mesh).positions.size(), book(3, 1).positions.size() + 1);
  mesh.set_point(copies[2], {9, 9, 9});
  expect_joined({0, 1, 0});
}

// --------------------------------------------------------------------------------------------------------------------

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
