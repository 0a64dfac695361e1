// What the triangles and the instances of certain assets are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "assets.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

class GltfTriangles : public ::testing::Test {
 protected:
  void SetUp() override {
    if (asset_files({"gltf-tiny"}).empty()) GTEST_SKIP() << "the test assets are not there: " << WHITTLE_TEST_ASSETS;
  }

  static Asset tiny(const std::string& name) { return Asset::read(asset_file("gltf-tiny/" + name)); }
  static Asset realistic(const std::string& name) { return Asset::read(asset_file("gltf-realistic/" + name)); }
  static Asset quirky(const std::string& name) { return Asset::read(asset_file("gltf-quirky/" + name)); }
};

const Attribute& attribute_of(const IndexedMesh& mesh, const std::string& name) {
  const auto found = std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                                  [&](const Attribute& attribute) { return attribute.name == name; });
  if (found == mesh.attributes.end()) throw std::out_of_range("no attribute " + name);
  return *found;
}

std::vector<std::string> names_of(const IndexedMesh& mesh) {
  std::vector<std::string> names;
  for (const Attribute& attribute : mesh.attributes) names.push_back(attribute.name);
  return names;
}

Vec3 normal_of(const IndexedMesh& mesh, const Triangle& face) {
  const Vec3& p = mesh.positions[face[0]];
  return (mesh.positions[face[1]] - p).cross(mesh.positions[face[2]] - p);
}

TEST_F(GltfTriangles, HaveTheFilesAttributes) {
  const IndexedMesh mesh = realistic("mannequiny.glb").triangles(0);
  EXPECT_EQ(mesh.faces.size(), 13832);
  EXPECT_EQ(mesh.group_names.size(), 3);
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.colors.size(), mesh.positions.size());
  EXPECT_TRUE(mesh.wedges.empty());
  EXPECT_THAT(names_of(mesh), IsSupersetOf({"TEXCOORD_0", "TEXCOORD_1", "COLOR_1", "JOINTS_0+WEIGHTS_0"}));
  EXPECT_EQ(attribute_of(mesh, "TEXCOORD_1").kind, AttributeKind::texcoord);
  EXPECT_EQ(attribute_of(mesh, "COLOR_1").kind, AttributeKind::color);
  const Attribute& joints = attribute_of(mesh, "JOINTS_0+WEIGHTS_0");
  EXPECT_EQ(joints.kind, AttributeKind::joint_weights);
  ASSERT_EQ(joints.n_components, 8);
  for (std::size_t v = 0; v < joints.size(); ++v) {
    const auto value = joints.value(v);
    EXPECT_LT(value[0], 47);
    EXPECT_NEAR(value[4] + value[5] + value[6] + value[7], 1, 1e-5);
  }
}

TEST_F(GltfTriangles, HaveMorphTargets) {
  const IndexedMesh mesh = tiny("bli_01_morphed_cube/01_morphed_cube.gltf").triangles(0);
  EXPECT_EQ(attribute_of(mesh, "TANGENT").kind, AttributeKind::tangent);
  EXPECT_EQ(attribute_of(mesh, "target 0 POSITION").kind, AttributeKind::displacement);
  EXPECT_EQ(attribute_of(mesh, "target 0 NORMAL").kind, AttributeKind::direction);
  const auto& values = attribute_of(mesh, "target 0 POSITION").values;
  EXPECT_TRUE(std::any_of(values.begin(), values.end(), [](double x) { return x != 0; }));
}

TEST_F(GltfTriangles, HaveAttributesOfTheFilesOwn) {
  const IndexedMesh mesh = tiny("generated/extras_unknown_extensions.gltf").triangles(0);
  EXPECT_EQ(attribute_of(mesh, "_TEMPERATURE").kind, AttributeKind::scalar);
  const IndexedMesh box = quirky("dra_BoxMeta/BoxMeta.gltf").triangles(0);
  EXPECT_EQ(attribute_of(box, "_FEATURE_ID_0").kind, AttributeKind::category);
  EXPECT_EQ(attribute_of(box, "_FEATURE_ID_0").type, ScalarType::uint8);
  EXPECT_EQ(attribute_of(box, "_DIRECTION").n_components, 3);
}

TEST_F(GltfTriangles, AreZeroWhereAPrimitiveHasNoSuchAttribute) {
  const IndexedMesh mesh = tiny("gag_Mesh_PrimitivesUV_04/Mesh_PrimitivesUV_04.gltf").triangles(0);
  ASSERT_EQ(mesh.face_groups, (std::vector<Index>{0, 1}));
  const Attribute& texcoord = attribute_of(mesh, "TEXCOORD_0");
  const auto is_zero = [&](std::size_t f) {
    return std::all_of(mesh.faces[f].begin(), mesh.faces[f].end(), [&](Index v) {
      return std::all_of(texcoord.value(v).begin(), texcoord.value(v).end(), [](double x) { return x == 0; });
    });
  };
  EXPECT_NE(is_zero(0), is_zero(1));
}

TEST_F(GltfTriangles, OfStripsAndFansFaceTheSameWay) {
  const auto mode = [](const std::string& number) {
    return tiny("gag_Mesh_PrimitiveMode_" + number + "/Mesh_PrimitiveMode_" + number + ".gltf").triangles(0);
  };
  const IndexedMesh triangles = mode("06");
  for (const IndexedMesh& mesh : {mode("04"), mode("05")}) {
    ASSERT_EQ(mesh.faces.size(), 2);
    for (const Triangle& face : mesh.faces) {
      EXPECT_GT(normal_of(mesh, face).dot(normal_of(triangles, triangles.faces[0])), 0);
    }
  }
}

TEST_F(GltfTriangles, LeaveLinesAndPointsOut) {
  Asset asset = tiny("generated/triangles_lines_points_mixed.gltf");
  const IndexedMesh mesh = asset.triangles(0);
  EXPECT_EQ(mesh.faces.size(), 128);
  EXPECT_EQ(mesh.group_names.size(), 3);
  EXPECT_EQ(tiny("gag_Mesh_PrimitiveMode_00/Mesh_PrimitiveMode_00.gltf").n_triangles(0), 0);
}

TEST_F(GltfTriangles, HaveWhatSparseValuesReplace) {
  const IndexedMesh mesh = tiny("dra_SimpleSparseAccessor/SimpleSparseAccessor.gltf").triangles(0);
  const auto has = [&](const Vec3& position) {
    return std::find(mesh.positions.begin(), mesh.positions.end(), position) != mesh.positions.end();
  };
  EXPECT_TRUE(has({1, 2, 0}));
  EXPECT_TRUE(has({3, 3, 0}));
  EXPECT_TRUE(has({5, 4, 0}));
  EXPECT_FALSE(has({1, 1, 0}));
}

TEST_F(GltfTriangles, OfDracoAreThoseThatItWasMadeOf) {
  WHITTLE_NEEDS_CODECS();
  const Asset packed = realistic("helicopter_draco.gltf");
  const Asset plain = realistic("helicopter.glb");
  ASSERT_EQ(packed.n_meshes(), plain.n_meshes());
  for (std::size_t m = 0; m < plain.n_meshes(); ++m) {
    const IndexedMesh a = packed.triangles(m);
    const IndexedMesh b = plain.triangles(m);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.colors, b.colors);
    EXPECT_EQ(names_of(a), names_of(b));
  }
}

/// The same face with its lowest number first.
Triangle turned(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

TEST_F(GltfTriangles, OfMeshoptAreThoseOfItsFallback) {
  WHITTLE_NEEDS_CODECS();
  const auto file = asset_file("gltf-quirky/pip_meshopt-fallback/meshopt-fallback.gltf");
  Json document = Json::parse(bytes_of_file(file));
  for (Json& view : document["bufferViews"]) view.erase("extensions");
  document.erase("extensionsRequired");
  const Asset packed = Asset::read(file);
  const Asset plain = Asset::read(document.dump(), "fallback.gltf", file.parent_path());
  for (std::size_t m = 0; m < packed.n_meshes(); ++m) {
    const IndexedMesh a = packed.triangles(m);
    const IndexedMesh b = plain.triangles(m);
    EXPECT_EQ(a.positions, b.positions);
    // The fallback has normals that are still encoded.
    for (const auto& n : a.normals) EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 0.03);
    ASSERT_EQ(a.faces.size(), b.faces.size());
    for (std::size_t f = 0; f < a.faces.size(); ++f) EXPECT_EQ(turned(a.faces[f]), turned(b.faces[f]));
  }
}

TEST_F(GltfTriangles, AreInstancedByNodes) {
  const Asset asset = tiny("gag_Instancing_06/Instancing_06.gltf");
  EXPECT_EQ(asset.n_instances(0), 2);
  const auto transforms = asset.world_transforms(0);
  ASSERT_EQ(transforms.size(), 2);
  EXPECT_NE(transforms[0], transforms[1]);
  const Asset instanced = tiny("bli_24_gpu_instancing/24_gpu_instancing.gltf");
  std::size_t n = 0;
  for (std::size_t m = 0; m < instanced.n_meshes(); ++m) {
    EXPECT_EQ(instanced.world_transforms(m).size(), instanced.n_instances(m));
    n += instanced.n_instances(m);
  }
  EXPECT_GT(n, instanced.n_meshes());
}

TEST_F(GltfTriangles, OfAnAssetArePlacedByAllItsNodes) {
  const Asset asset = realistic("dungeon_scene_a.glb");
  std::size_t n_placed = 0;
  std::size_t n_mirrored = 0;
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    n_placed += asset.n_triangles(m) * asset.n_instances(m);
    for (const Eigen::Matrix4d& matrix : asset.world_transforms(m)) n_mirrored += matrix.determinant() < 0 ? 1 : 0;
  }
  EXPECT_EQ(n_placed, 116'932);
  EXPECT_GT(n_mirrored, 0);
}

}  // namespace
}  // namespace whittle::gltf::test
