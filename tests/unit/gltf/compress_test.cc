// Compressed output: how far what is read back is off, and how small it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "assets.hh"
#include "mesh_comparison.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/gltf/asset.hh"

namespace whittle::gltf::test {
namespace {

/// The longest side of the box around the mesh.
double extent(const IndexedMesh& mesh) { return bounds_of(mesh.positions).sizes().maxCoeff(); }

void expect_close(const IndexedMesh& a, const IndexedMesh& b) {
  ASSERT_EQ(a.faces.size(), b.faces.size());
  ASSERT_EQ(a.attributes.size(), b.attributes.size());
  ASSERT_EQ(a.normals.empty(), b.normals.empty());
  if (a.faces.empty()) return;
  const double step = extent(a) / 65536;
  EXPECT_LE((mean_corner(a) - mean_corner(b)).cwiseAbs().maxCoeff(), step);
  for (std::size_t i = 0; i < a.attributes.size(); ++i) {
    const Attribute& attribute = a.attributes[i];
    EXPECT_EQ(attribute.name, b.attributes[i].name);
    const bool is_direction = attribute.kind == AttributeKind::tangent;
    const double largest = std::abs(*std::max_element(attribute.values.begin(), attribute.values.end()));
    const double tolerance = is_direction                                    ? 0.01
                             : attribute.kind == AttributeKind::displacement ? step
                                                                             : std::max(1.0, largest) / 32768;
    const auto mean_of_a = mean_value(a, attribute);
    const auto mean_of_b = mean_value(b, b.attributes[i]);
    for (std::size_t k = 0; k < mean_of_a.size(); ++k) {
      EXPECT_NEAR(mean_of_a[k], mean_of_b[k], tolerance) << attribute.name << ' ' << k;
    }
  }
}

TEST(GltfCompress, IsReadBackAlmostAsItWas) {
  WHITTLE_NEEDS_CODECS();
  const auto files = asset_files({"gltf-realistic", "gltf-tiny"});
  WHITTLE_NEEDS_ASSETS(files);
  for (const auto& file : files) {
    SCOPED_TRACE(asset_name(file));
    Asset asset = Asset::read(file);
    bool has_faces = false;
    for (std::size_t m = 0; m < asset.n_meshes(); ++m) {
      asset.set_triangles(m, asset.triangles(m));
      has_faces = has_faces || asset.n_triangles(m) > 0;
    }
    const std::string glb = asset.write_glb({.compress = true});
    EXPECT_EQ(has_faces, glb.find("EXT_meshopt_compression") != std::string::npos);
    const Asset again = Asset::read(glb, "output.glb");
    for (std::size_t m = 0; m < asset.n_meshes(); ++m) expect_close(asset.triangles(m), again.triangles(m));
    EXPECT_EQ(without_geometry(load_glb(glb)), without_geometry(load_document(file)));
  }
}

TEST(GltfCompress, PositionsAreWithinAStep) {
  WHITTLE_NEEDS_CODECS();
  const auto file = asset_file("gltf-realistic/mannequiny.glb");
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-realistic"}));
  Asset asset = Asset::read(file);
  const IndexedMesh mesh = asset.triangles(0);
  asset.set_triangles(0, mesh);
  const IndexedMesh again = Asset::read(asset.write_glb({.compress = true}), "output.glb").triangles(0);
  const double step = extent(mesh) / 65536;
  // Corner by corner, in the order of the primitives' faces, which changes: sorted along x.
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> a = corners_along(axis, mesh);
    const std::vector<double> b = corners_along(axis, again);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], step);
  }
}

TEST(GltfCompress, TakesAThirdOfTheBytesOfGeometry) {
  WHITTLE_NEEDS_CODECS();
  const auto file = asset_file("gltf-realistic/helicopter.glb");
  WHITTLE_NEEDS_ASSETS(asset_files({"gltf-realistic"}));
  Asset asset = Asset::read(file);
  for (std::size_t m = 0; m < asset.n_meshes(); ++m) asset.set_triangles(m, asset.triangles(m));
  EXPECT_LT(3 * asset.write_glb({.compress = true}).size(), asset.write_glb().size());
}

}  // namespace
}  // namespace whittle::gltf::test
