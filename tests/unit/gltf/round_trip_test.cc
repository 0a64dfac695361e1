// Assets that are read and written: triangles come back as they were, and nothing else changes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "assets.hh"
#include "mesh_comparison.hh"
#include "support/temporary_folder.hh"
#include "whittle/core/wedges.hh"
#include "whittle/gltf/asset.hh"
#include "whittle/io/errors.hh"

namespace whittle::gltf::test {
namespace {

const std::vector<std::string> accepted_folders = {"gltf-realistic", "gltf-tiny", "gltf-quirky"};

/// Those that aren't valid glTF.
bool may_be_refused(const std::string& name) {
  return name.find("mesh-custom-attributes") != std::string::npos || name.find("mesh-sparse") != std::string::npos;
}

void expect_same_attribute(const Attribute& a, const Attribute& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.kind, b.kind) << a.name;
  EXPECT_EQ(a.n_components, b.n_components) << a.name;
  EXPECT_TRUE(a.values == b.values) << a.name;
}

void expect_same_triangles(const IndexedMesh& a, const IndexedMesh& b) {
  EXPECT_TRUE(are_positions_same(a, b));
  EXPECT_TRUE(a.faces == b.faces);
  EXPECT_TRUE(a.normals == b.normals);
  EXPECT_TRUE(a.colors == b.colors);
  EXPECT_TRUE(a.face_groups == b.face_groups);
  EXPECT_EQ(a.group_names, b.group_names);
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  for (std::size_t i = 0; i < a.attributes.size(); ++i) expect_same_attribute(a.attributes[i], b.attributes[i]);
}

/// Replaces the triangles of all meshes by themselves.
void replace_all(Asset& asset) {
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) asset.set_triangles(m, asset.triangles(m));
}

TEST(GltfRoundTrip, KeepsTrianglesToTheBitAndAllElse) {
  const auto files = asset_files(accepted_folders);
  WHITTLE_NEEDS_ASSETS(files);
  for (const auto& file : files) {
    SCOPED_TRACE(asset_name(file));
    try {
      Asset asset = Asset::read(file);
      std::vector<IndexedMesh> meshes;
      for (std::size_t m = 0; m < asset.n_meshes(); ++m) meshes.push_back(asset.triangles(m));
      replace_all(asset);
      const std::string glb = asset.write_glb();
      const Asset again = Asset::read(glb, "output.glb");
      ASSERT_EQ(again.n_meshes(), meshes.size());
      for (std::size_t m = 0; m < meshes.size(); ++m) {
        EXPECT_EQ(again.n_triangles(m), meshes[m].faces.size());
        expect_same_triangles(meshes[m], again.triangles(m));
      }
      EXPECT_EQ(without_geometry(load_glb(glb)), without_geometry(load_document(file)));
    } catch (const io::ReadError& error) {
      EXPECT_TRUE(may_be_refused(asset_name(file))) << error.what();
    }
  }
}

TEST(GltfRoundTrip, KeepsWhatIsNotReplaced) {
  const auto files = asset_files(accepted_folders);
  WHITTLE_NEEDS_ASSETS(files);
  for (const auto& file : files) {
    SCOPED_TRACE(asset_name(file));
    if (may_be_refused(asset_name(file))) continue;
    const Asset asset = Asset::read(file);
    const Document before = load_document(file);
    const Document after = load_glb(asset.write_glb());
    Json rest = before.json;
    Json same_rest = after.json;
    for (Json* json : {&rest, &same_rest}) {
      json->erase("bufferViews");
      json->erase("buffers");
    }
    EXPECT_EQ(rest, same_rest);
    const std::size_t n_views = before.json.contains("bufferViews") ? before.json["bufferViews"].size() : 0;
    for (std::size_t v = 0; v < n_views; ++v) ASSERT_TRUE(before.view(v) == after.view(v)) << "view " << v;
  }
}

TEST(GltfRoundTrip, LeavesNoBytesOfReplacedGeometry) {
  const auto file = asset_file("gltf-realistic/FlightHelmet.glb");
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-realistic"}));
  Asset asset = Asset::read(file);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
    IndexedMesh mesh = asset.triangles(m);
    // One face of each primitive.
    IndexedMesh few = mesh;
    few.faces.clear();
    few.face_groups.clear();
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      if (!few.face_groups.empty() && few.face_groups.back() == mesh.face_groups[f]) continue;
      few.faces.push_back(mesh.faces[f]);
      few.face_groups.push_back(mesh.face_groups[f]);
    }
    asset.set_triangles(m, few);
  }
  const Document before = load_document(file);
  std::size_t n_image_bytes = 0;
  for (const Json& image : before.json["images"]) n_image_bytes += before.view(image["bufferView"]).size();
  const Document after = load_glb(asset.write_glb());
  EXPECT_LT(after.buffers[0].size(), n_image_bytes + 20'000);
  EXPECT_EQ(after.json["accessors"].size(), before.json["accessors"].size());
  EXPECT_EQ(after.json["bufferViews"].size(), before.json["accessors"].size() + before.json["images"].size());
}

TEST(GltfRoundTrip, WritesTextWithABufferBesideIt) {
  const auto files = asset_files({"gltf-tiny"});
  WHITTLE_NEEDS_ASSETS(files);
  const whittle::test::TemporaryFolder folder;
  for (const auto& file : files) {
    SCOPED_TRACE(asset_name(file));
    Asset asset = Asset::read(file);
    replace_all(asset);
    const std::filesystem::path path = folder / (file.stem().string() + " copy.gltf");
    asset.write(path);
    EXPECT_EQ(without_geometry(load_document(path)), without_geometry(load_document(file)));
    const Asset again = Asset::read(path);
    for (std::size_t m = 0; m < asset.n_meshes(); ++m) expect_same_triangles(asset.triangles(m), again.triangles(m));
    for (const auto& image : asset.image_files()) EXPECT_TRUE(std::filesystem::exists(folder.path() / image)) << image;
  }
}

TEST(GltfRoundTrip, OverwritesNoBufferOfTheInput) {
  const auto file = asset_file("gltf-tiny/bli_22_vertex_color/22_vertex_color.gltf");
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-tiny"}));
  const whittle::test::TemporaryFolder folder;
  std::filesystem::copy_file(file, folder.path() / "in.gltf");
  std::filesystem::copy_file(file.parent_path() / "22_vertex_color.bin", folder.path() / "22_vertex_color.bin");
  Asset::read(folder.path() / "in.gltf").write(folder.path() / "22_vertex_color.gltf");
  EXPECT_EQ(bytes_of_file(folder.path() / "22_vertex_color.bin"),
            bytes_of_file(file.parent_path() / "22_vertex_color.bin"));
  EXPECT_THAT(folder.files(), ::testing::Contains("22_vertex_color_simplified.bin"));
}

TEST(GltfRoundTrip, TakesWedges) {
  const auto files = asset_files({"gltf-tiny", "gltf-realistic"});
  WHITTLE_NEEDS_ASSETS(files);
  for (const auto& file : files) {
    SCOPED_TRACE(asset_name(file));
    Asset asset = Asset::read(file);
    std::vector<IndexedMesh> meshes;
    for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
      meshes.push_back(asset.triangles(m));
      IndexedMesh with_wedges = meshes.back();
      make_wedge_table(with_wedges);
      asset.set_triangles(m, std::move(with_wedges));
    }
    const Asset again = Asset::read(asset.write_glb(), "output.glb");
    for (std::size_t m = 0; m < meshes.size(); ++m) expect_same_triangles(again.triangles(m), meshes[m]);
  }
}

}  // namespace
}  // namespace whittle::gltf::test
