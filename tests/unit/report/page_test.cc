#include "whittle/report/page.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "page_bytes.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::report {
namespace {

using ::testing::AllOf;
using ::testing::Gt;
using ::testing::HasSubstr;
using ::testing::Le;
using ::testing::Not;

PageSurface surface_of(const std::string& name, IndexedMesh mesh) {
  put_in_page_order(mesh);
  return {name, std::move(mesh), {}, {}, {}, std::nullopt};
}

std::string written(const Page& page) {
  std::ostringstream out;
  write_page(out, page);
  return std::move(out).str();
}

nlohmann::json data_of(const std::string& page) {
  const std::string begin = "<script id=\"whittle-data\" type=\"application/json\">";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

/// Faces by their corners, wherever they begin and in any order.
std::vector<std::array<Vec3, 3>> shape_of(const IndexedMesh& mesh) {
  const auto before = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::vector<std::array<Vec3, 3>> faces;
  for (const auto& [a, b, c] : mesh.faces) {
    std::array<Vec3, 3> face{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    std::rotate(face.begin(), std::min_element(face.begin(), face.end(), before), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end(), [&](const auto& x, const auto& y) {
    return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end(), before);
  });
  return faces;
}

TEST(PageOrder, KeepsTheSurface) {
  for (const auto& [name, mesh] : test::all_meshes()) {
    SCOPED_TRACE(name);
    IndexedMesh ordered = mesh;
    const PageOrder order = put_in_page_order(ordered);
    EXPECT_EQ(shape_of(ordered), shape_of(mesh));
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      EXPECT_EQ(ordered.positions[order.of_vertex[v]], mesh.positions[v]);
    }
    for (Index f = 0; f < mesh.faces.size(); ++f) {
      Triangle face = mesh.faces[f];
      for (Index& v : face) v = order.of_vertex[v];
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      EXPECT_EQ(ordered.faces[order.of_face[f]], face);
    }
  }
}

TEST(Page, NamesItsMeshesAndCounts) {
  const IndexedMesh mesh = test::closed_meshes().front().mesh;
  const IndexedMesh small = decimate(mesh, DecimateTarget::faces(20)).mesh;
  Page page{"a title", {}, surface_of("the original", mesh), {surface_of("the result", small)}, std::nullopt, {}, {}};
  const nlohmann::json data = data_of(written(page));
  EXPECT_EQ(data["original"]["name"], "the original");
  EXPECT_EQ(data["original"]["faces"], mesh.faces.size());
  EXPECT_EQ(data["results"][0]["faces"], small.faces.size());
  EXPECT_TRUE(data["recording"].is_null());
}

TEST(Page, LetsNoTextBecomeMarkup) {
  const IndexedMesh mesh = test::closed_meshes().front().mesh;
  const std::string evil = "</script><script>alert(\"1\")</script>'&{{bytes}}";
  Page page{evil, evil, surface_of(evil, mesh), {}, std::nullopt, {{evil, "<svg></svg>"}}, {}};
  page.tables = {{evil, {evil}, {{evil, evil, {evil}, 0}}}};
  page.json = evil;
  const std::string html = written(page);
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, HasSubstr("&lt;/script&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&#39;&amp;{{bytes}}"));
  EXPECT_EQ(data_of(html)["original"]["name"], evil);
}

TEST(Page, LoadsNothing) {
  const IndexedMesh mesh = test::closed_meshes().front().mesh;
  const std::string html = written({"t", {}, surface_of("m", mesh), {}, std::nullopt, {}, {}});
  EXPECT_THAT(html, HasSubstr("http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'"));
  for (const char* const word : {"src=", "href=", "@import", "url("}) {
    EXPECT_THAT(html.substr(0, html.find("<script>")), Not(HasSubstr(word)));
  }
}

TEST(Page, RefusesAMeshWithoutFaces) {
  std::ostringstream out;
  EXPECT_THROW(write_page(out, {"t", {}, {"m", IndexedMesh{}, {}, {}, {}, std::nullopt}, {}, std::nullopt, {}, {}}),
               std::invalid_argument);
}

TEST(CoarseFaces, AreNoneForAMeshOfFewFaces) {
  EXPECT_TRUE(coarse_faces(test::closed_meshes().front().mesh).faces.empty());
}

TEST(CoarseFaces, HaveTheTexturesOfTheirCharts) {
  IndexedMesh mesh = test::charted_cube(60);
  join_equal_wedges(mesh);
  put_in_page_order(mesh);
  const CoarseFaces coarse = coarse_faces(mesh, 1);
  ASSERT_THAT(coarse.faces.size(), AllOf(Gt(9'000U), Le(10'000U)));
  ASSERT_EQ(coarse.wedges.size(), 3 * coarse.faces.size());
  ASSERT_EQ(coarse.face_groups.size(), coarse.faces.size());
  for (std::size_t corner = 0; corner < coarse.wedges.size(); ++corner) {
    const Index side = coarse.face_groups[corner / 3];
    const auto expected = test::chart_position(side, mesh.positions[coarse.faces[corner / 3][corner % 3]]);
    const auto found = mesh.attributes[0].value(coarse.wedges[corner]);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << "corner " << corner;
  }
}

TEST(CoarseFaces, OfAMeshWithoutSeamsHaveNoWedges) {
  IndexedMesh mesh = without_attributes(test::charted_cube(60));
  put_in_page_order(mesh);
  const CoarseFaces coarse = coarse_faces(mesh, 1);
  EXPECT_FALSE(coarse.faces.empty());
  EXPECT_TRUE(coarse.wedges.empty() && coarse.face_groups.empty());
}

}  // namespace
}  // namespace whittle::report
