#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "packed_values.hh"
#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"
#include "whittle/report/page.hh"

namespace whittle::report {
namespace {

IndexedMesh cube() {
  IndexedMesh mesh = test::charted_cube(3);
  for (std::size_t w = 0; w < n_wedges(mesh); ++w) mesh.colors.push_back({0.5F, 0, 1, 1});
  join_equal_wedges(mesh);
  return mesh;
}

Material textured(const std::string& rest, const std::string& begin = "\x89PNG\r\n\x1A\n") {
  Material material;
  material.base_color_texture =
      Texture{.image = std::make_shared<const Image>(Image{.bytes = begin + rest}), .texcoord = "uv"};
  return material;
}

PageSurface in_page_order(IndexedMesh mesh) {
  put_in_page_order(mesh);
  return {"cube", std::move(mesh), {}, {}, {}, std::nullopt};
}

/// What the page says of the looks of two surfaces, and of its images.
struct Looks {
  nlohmann::json original, result, images;
};

Looks looks_of(PageSurface original, PageSurface result) {
  Page page{"t", {}, std::move(original), {}, std::nullopt, {}, {}};
  page.results.push_back(std::move(result));
  std::ostringstream out;
  write_page(out, page);
  const std::string html = std::move(out).str();
  const std::string begin = "<script id=\"whittle-data\" type=\"application/json\">";
  const std::size_t at = html.find(begin) + begin.size();
  const nlohmann::json data = nlohmann::json::parse(html.substr(at, html.find("</script>", at) - at));
  return {data["original"]["look"], data["results"][0]["look"], data["images"]};
}

/// What a corner has, wherever it is in the mesh.
using Corner = std::tuple<std::array<double, 3>, std::array<float, 3>, Color, std::array<double, 2>, Index>;

std::multiset<Corner> corners_of(const IndexedMesh& mesh) {
  std::multiset<Corner> corners;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.faces[f][k]];
      const Index w = mesh.wedge(f, k);
      const auto uv = mesh.attributes[0].value(w);
      corners.insert({{p.x(), p.y(), p.z()}, mesh.normals[w], mesh.colors[w], {uv[0], uv[1]}, mesh.face_groups[f]});
    }
  }
  return corners;
}

TEST(PageOrder, KeepsWhatWedgesAndFacesHave) {
  const IndexedMesh mesh = cube();
  IndexedMesh ordered = mesh;
  put_in_page_order(ordered);
  EXPECT_EQ(corners_of(ordered), corners_of(mesh));
  EXPECT_EQ(ordered.group_names, mesh.group_names);
  EXPECT_EQ(n_wedges(ordered), n_wedges(mesh));
}

TEST(PageOrder, GivesVerticesTheFirstWedges) {
  for (const bool has_seams : {true, false}) {
    IndexedMesh mesh = cube();
    if (!has_seams) drop_seams(mesh);
    put_in_page_order(mesh);
    EXPECT_EQ(mesh.wedges.empty(), !has_seams);
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index w = mesh.wedge(f, k);
        if (w < mesh.positions.size()) {
          EXPECT_EQ(w, mesh.faces[f][k]);
        }
      }
    }
  }
}

TEST(PageLook, IsNotThereForAShapeAlone) {
  const IndexedMesh shape = without_attributes(cube());
  const Looks looks = looks_of(in_page_order(shape), in_page_order(shape));
  EXPECT_TRUE(looks.original.is_null());
  EXPECT_TRUE(looks.images.empty());
}

TEST(PageLook, HasEachImageOnce) {
  PageSurface original = in_page_order(cube());
  PageSurface result = original;
  original.materials = {textured("a"), textured("b"), textured("a"), {}};
  result.materials = {textured("b"), textured("a")};
  const Looks looks = looks_of(original, result);
  ASSERT_EQ(looks.images.size(), 2U);
  EXPECT_EQ(looks.images[0]["type"], "image/png");
  EXPECT_EQ(looks.original["materials"][0]["image"], 0);
  EXPECT_EQ(looks.original["materials"][2]["image"], 0);
  EXPECT_EQ(looks.result["materials"][0]["image"], 1);
  EXPECT_TRUE(looks.original["materials"][3]["image"].is_null());
  EXPECT_EQ(looks.original["materials"].size(), 5U) << "the last one is that of faces without a material";
  EXPECT_EQ(looks.original["texcoords"].size(), 1U);
}

TEST(PageLook, HasNoImageWithoutTextureCoordinates) {
  PageSurface surface = in_page_order(cube());
  surface.materials = {textured("a")};
  surface.materials[0].base_color = {1, 0, 0, 1};
  surface.materials[0].base_color_texture->texcoord = "TEXCOORD_7";
  surface.materials[0].base_color_texture->is_tinted = false;
  const Looks looks = looks_of(surface, surface);
  EXPECT_TRUE(looks.images.empty());
  EXPECT_TRUE(looks.original["materials"][0]["image"].is_null());
  EXPECT_EQ(looks.original["materials"][0]["colour"], (nlohmann::json{1, 0, 0, 1})) << "nothing hides it";
}

TEST(PageLook, HasNoFileThatIsNoImage) {
  PageSurface surface = in_page_order(cube());
  surface.materials = {textured("root:x:0:0", "")};
  EXPECT_TRUE(looks_of(surface, surface).images.empty());
}

TEST(AttributeMaps, SayHowFarATextureIsOff) {
  const IndexedMesh mesh = cube();
  IndexedMesh shifted = mesh;
  for (std::size_t i = 0; i < shifted.attributes[0].values.size(); i += 2) shifted.attributes[0].values[i] += 0.125;
  for (Color& color : shifted.colors) color[0] += 0.25F;
  std::map<AttributeKind, AttributeMap> maps;
  for (AttributeMap& map : attribute_maps(mesh, shifted)) maps[map.kind] = std::move(map);
  ASSERT_EQ(maps.size(), 3U);
  EXPECT_NEAR(maps[AttributeKind::texcoord].max, 0.125, 1e-12);
  EXPECT_NEAR(maps[AttributeKind::texcoord].usual, 0.125, 1e-12);
  EXPECT_NEAR(maps[AttributeKind::color].max, 0.25, 1e-6);
  EXPECT_NEAR(maps[AttributeKind::normal].max, 0, 1e-6);
  for (const AttributeMap& map : attribute_maps(mesh, mesh)) EXPECT_NEAR(map.max, 0, 1e-9) << map.name;
}

TEST(AttributeMaps, AreThoseThatBothMeshesHave) {
  IndexedMesh other = cube();
  other.colors.clear();
  EXPECT_EQ(attribute_maps(cube(), other).size(), 2U);
  EXPECT_TRUE(attribute_maps(cube(), without_attributes(other)).empty());
}

TEST(PackedValue, HasEvenStepsThenEvenFactors) {
  const ValueRange range{8, 2};
  EXPECT_EQ(packed_value(0, range), 0);
  EXPECT_EQ(packed_value(1, range), 50);
  EXPECT_EQ(packed_value(2, range), 100);
  EXPECT_EQ(packed_value(8, range), 127);
  EXPECT_EQ(packed_value(-1, range), 178);
  EXPECT_EQ(packed_value(4, {4, 0}), 127) << "nearly everywhere 0";
  EXPECT_EQ(packed_value(0, {0, 0}), 0);
}

}  // namespace
}  // namespace whittle::report
