// What of face data names regions.
#include "whittle/core/regions.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"

namespace whittle::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr Index n_cells = 16;

/// A square of 16 × 16 cells of two faces. \param value_of column and row → value of both faces
template <class ValueOf>
Attribute by_cell(const IndexedMesh& square, AttributeKind kind, const ValueOf& value_of) {
  Attribute attribute{.name = "label", .kind = kind, .n_components = 1, .values = {}, .type = ScalarType::uint8};
  for (const Triangle& face : square.faces) {
    Vec3 low = square.positions[face[0]];
    for (const Index v : face) low = low.cwiseMin(square.positions[v]);
    attribute.values.push_back(value_of(static_cast<Index>(low.x() + 0.5), static_cast<Index>(low.y() + 0.5)));
  }
  return attribute;
}

Attribute quarters(const IndexedMesh& square, AttributeKind kind) {
  return by_cell(square, kind, [](Index x, Index y) { return x / 8 + 2 * (y / 8); });
}

TEST(Regions, AreNamedByNumbersOfThingsThatStandInAreas) {
  const IndexedMesh square = noisy_grid(n_cells, n_cells, 0, 1);
  ASSERT_EQ(square.faces.size(), 2 * n_cells * n_cells);
  const auto names = [&](const Attribute& attribute) { return names_regions(square, attribute); };
  EXPECT_TRUE(names(quarters(square, AttributeKind::category)));
  EXPECT_TRUE(names(quarters(square, AttributeKind::color)));
  EXPECT_FALSE(names(quarters(square, AttributeKind::scalar))) << "integers whose name says that they measure";
  Attribute reals = quarters(square, AttributeKind::scalar);
  reals.type = ScalarType::float32;
  EXPECT_TRUE(names(reals)) << "all are whole";
  reals.values.back() = 0.5;
  EXPECT_FALSE(names(reals));

  Attribute numbers = quarters(square, AttributeKind::category);
  for (std::size_t f = 0; f < numbers.values.size(); ++f) numbers.values[f] = static_cast<double>(f);
  EXPECT_FALSE(names(numbers)) << "a number a face";
  const auto ramp = [](Index x, Index y) { return x + n_cells * y; };
  EXPECT_TRUE(names(by_cell(square, AttributeKind::category, ramp))) << "a number for two faces";
  EXPECT_FALSE(names(by_cell(square, AttributeKind::color, ramp))) << "a shade for two faces";
}

TEST(Regions, HaveTheSameOfAllThatNamesThings) {
  IndexedMesh square = noisy_grid(n_cells, n_cells, 0, 1);
  EXPECT_THAT(face_regions(square), IsEmpty());
  square.face_attributes = {by_cell(square, AttributeKind::category, [](Index x, Index) { return x / 8; }),
                            by_cell(square, AttributeKind::category, [](Index, Index y) { return 7 - 2.0 * (y / 8); })};
  square.face_attributes[1].name = "red,green";
  const Attribute both = quarters(square, AttributeKind::category);
  const std::vector<Index> regions = face_regions(square);
  ASSERT_EQ(regions.size(), square.faces.size());
  for (std::size_t f = 0; f < regions.size(); ++f) {
    for (std::size_t g = 0; g < f; ++g) EXPECT_EQ(regions[f] == regions[g], both.values[f] == both.values[g]);
  }
  EXPECT_EQ(regions.front(), 0U);
  EXPECT_EQ(seam_edges(square).size(), 2 * n_cells);

  EXPECT_THAT(face_regions(square, std::vector<std::string>{}), IsEmpty());
  EXPECT_EQ(seam_edges(square, face_regions(square, {{"label"}})).size(), n_cells);
  square.face_attributes[1].n_components = 1;
  EXPECT_FALSE(has_name(square.face_attributes[1], "green")) << "one component has one name";
}

TEST(Regions, AreasEndAtSeams) {
  IndexedMesh square = noisy_grid(n_cells, n_cells, 0, 1);
  EXPECT_THAT(seam_areas(square, seam_edges(square)), IsEmpty());
  // Two stripes of one label with another one between, and far off a part without a seam.
  const std::size_t n_faces = square.faces.size();
  const auto n = static_cast<Index>(square.positions.size());
  for (const Vec3& p : icosahedron().positions) square.positions.push_back(p + Vec3(99, 0, 0));
  for (const auto& [a, b, c] : icosahedron().faces) square.faces.push_back({a + n, b + n, c + n});
  Attribute stripes = by_cell(square, AttributeKind::category, [](Index x, Index) { return x / 4 == 1 ? 1 : 0; });
  square.face_attributes = {stripes};
  const std::vector<Index> areas = seam_areas(square, seam_edges(square));
  ASSERT_EQ(areas.size(), square.faces.size());
  std::vector<Index> found(areas.begin(), areas.begin() + static_cast<std::ptrdiff_t>(n_faces));
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  EXPECT_EQ(found.size(), 3U);
  EXPECT_EQ(std::count(areas.begin(), areas.end(), invalid_index), 20);
}

}  // namespace
}  // namespace whittle::test
