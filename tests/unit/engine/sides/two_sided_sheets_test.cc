#include "whittle/engine/two_sided_sheets.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/shapes/two_sided.hh"
#include "whittle/core/wedges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

constexpr std::array all_efforts{Effort::fast, Effort::normal, Effort::best};

/// 20 × 20 squares with hills, 1600 faces with both sides.
IndexedMesh hills() { return noisy_grid(20, 20, 0.2, 5); }
IndexedMesh hills_with_backs() { return with_backs(hills()); }
/// Two sides where x < 10, one elsewhere.
IndexedMesh half_sheet() {
  IndexedMesh mesh = hills();
  const auto has_back = [&](const Triangle& face) {
    return std::all_of(face.begin(), face.end(), [&](Index v) { return mesh.positions[v].x() <= 10; });
  };
  const auto middle = std::stable_partition(mesh.faces.begin(), mesh.faces.end(), has_back);
  return with_backs(mesh, static_cast<std::size_t>(middle - mesh.faces.begin()));
}

Triangle sorted(Triangle face) {
  std::sort(face.begin(), face.end());
  return face;
}

/// +1 for a face whose corners ascend, −1 for one turned over.
int orientation(const Triangle& face) {
  return (face[0] < face[1]) + (face[1] < face[2]) + (face[2] < face[0]) == 2 ? 1 : -1;
}

/// The orientations of the faces on the same vertices: how many there are, and their sum.
struct SidesThere {
  int n = 0, sum = 0;
};
std::map<Triangle, SidesThere> sides_there(const IndexedMesh& mesh) {
  std::map<Triangle, SidesThere> sides;
  for (const Triangle& face : mesh.faces) {
    SidesThere& there = sides[sorted(face)];
    ++there.n;
    there.sum += orientation(face);
  }
  return sides;
}

void expect_two_sides_everywhere(const IndexedMesh& mesh, const std::string& what) {
  for (const auto& [face, sides] : sides_there(mesh)) {
    EXPECT_EQ(sides.n, 2) << what;
    EXPECT_EQ(sides.sum, 0) << what;
  }
}

bool have_same_shape(const IndexedMesh& a, const IndexedMesh& b) {
  return a.positions == b.positions && a.faces == b.faces;
}

TEST(TwoSidedSheet, IsSimplifiedAsItsFrontIs) {
  for (const CostTraits& traits : all_cost_traits) {
    const Cost cost = traits.cost;
    for (const Effort effort : all_efforts) {
      const std::string what = std::string(to_string(cost)) + ", effort " + std::to_string(static_cast<int>(effort));
      SimplifyOptions options;
      options.decimate.cost = cost;
      const Simplification both = simplify(hills_with_backs(), DecimateTarget::faces(200), effort, options);
      const Simplification front = simplify(hills(), DecimateTarget::faces(100), effort, options);
      EXPECT_EQ(both.result.stop, StopReason::target) << what;
      EXPECT_EQ(both.mesh.faces.size(), 2 * front.mesh.faces.size()) << what;
      EXPECT_EQ(both.result.n_faces, both.mesh.faces.size()) << what;
      EXPECT_EQ(both.mesh.positions, front.mesh.positions) << what;
      EXPECT_TRUE(std::equal(front.mesh.faces.begin(), front.mesh.faces.end(), both.mesh.faces.begin())) << what;
      expect_two_sides_everywhere(both.mesh, what);
    }
  }
}

TEST(TwoSidedSheet, HasFacesByTheOrderOfTheInput) {
  IndexedMesh mesh = hills_with_backs();
  for (Index f = 0; f + 1 < mesh.faces.size() / 2; f += 2) std::swap(mesh.faces[f], mesh.faces[800 + f]);
  const Decimation d = decimate(mesh, DecimateTarget::faces(200));
  EXPECT_GE(d.mesh.faces.size(), 198U);
  EXPECT_TRUE(std::is_sorted(d.face_origins.begin(), d.face_origins.end()));
  for (std::size_t f = 0; f < d.mesh.faces.size(); ++f) {
    const Triangle& origin = mesh.faces[d.face_origins[f]];
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(d.mesh.faces[f][k], d.vertex_map[origin[k]]);
  }
  expect_two_sides_everywhere(d.mesh, "mixed");
}

TEST(TwoSidedSheet, CountsNonmanifoldEdgesOfBothSides) {
  const Decimation d = decimate(with_backs(grid(2, 1)), DecimateTarget::as_far_as_possible());
  EXPECT_EQ(d.result.before.nonmanifold_edges, 3U);
  EXPECT_EQ(d.result.n_faces, d.mesh.faces.size());
}

TEST(TwoSidedSheet, EndsWhereFacesHaveOneSide) {
  const IndexedMesh mesh = half_sheet();
  ASSERT_EQ(mesh.faces.size(), 1200U);
  for (const Effort effort : all_efforts) {
    for (const std::uint64_t n : {600U, 301U, 60U}) {
      const std::string what = "effort " + std::to_string(static_cast<int>(effort)) + ", " + std::to_string(n);
      SimplifyOptions options;
      options.decimate.seams = Seams::keep;
      const Simplification s = simplify(mesh, DecimateTarget::faces(n), effort, options);
      EXPECT_LE(s.mesh.faces.size(), n) << what;
      EXPECT_GE(s.mesh.faces.size(), n - 10) << what;
      EXPECT_EQ(s.result.stop, StopReason::target) << what;
      for (const auto& [face, sides] : sides_there(s.mesh)) {
        EXPECT_EQ(sides.n == 2 ? 0 : 1, std::abs(sides.sum)) << what;
        const Vec3 center = (s.mesh.positions[face[0]] + s.mesh.positions[face[1]] + s.mesh.positions[face[2]]) / 3;
        EXPECT_EQ(sides.n == 2, center.x() < 10) << what << ": " << center.transpose();
      }
    }
  }
}

TEST(TwoSidedSheet, TellsTheListenerOfEachContractionOnce) {
  for (const IndexedMesh& mesh : {hills_with_backs(), half_sheet()}) {
    std::vector<Contraction> told;
    DecimateOptions options;
    options.keep_steps = true;
    options.listener = [&](const Contraction& contraction) { told.push_back(contraction); };
    const Decimation d = decimate(mesh, DecimateTarget::faces(300), options);
    EXPECT_EQ(told.size(), d.result.n_contractions);
    ASSERT_EQ(told.size(), d.steps.contractions.size());
    EXPECT_EQ(told.back().survivor, d.steps.contractions.back().survivor);
  }
}

TEST(TwoSidedSheet, DoesNotDependOnThreads) {
  for (const IndexedMesh& mesh : {hills_with_backs(), half_sheet()}) {
    SimplifyOptions options;
    options.decimate.threads = 1;
    const Simplification one = simplify(mesh, DecimateTarget::faces(200), Effort::normal, options);
    options.decimate.threads = 3;
    EXPECT_TRUE(have_same_shape(one.mesh, simplify(mesh, DecimateTarget::faces(200), Effort::normal, options).mesh));
  }
}

TEST(TwoSidedSheet, KeepsALimitOfTheError) {
  const Simplification s = simplify(half_sheet(), DecimateTarget::max_error(0.3));
  ASSERT_TRUE(s.result.proven_error.has_value());
  EXPECT_LT(s.mesh.faces.size(), 600U);
  const Simplification counted = simplify(half_sheet(), DecimateTarget::faces(900).or_max_error(0.3));
  EXPECT_LE(counted.mesh.faces.size(), 900U);
  EXPECT_GE(counted.mesh.faces.size(), 890U);
}

TEST(TwoSidedSheet, HasLevels) {
  for (const IndexedMesh& mesh : {hills_with_backs(), half_sheet()}) {
    const std::vector<std::uint64_t> counts{500, 301, 300, 50};
    std::vector<DecimateTarget> targets;
    for (const std::uint64_t n : counts) targets.push_back(DecimateTarget::faces(n));
    for (const Effort effort : all_efforts) {
      const std::vector<Simplification> levels = simplify_to_levels(mesh, targets, effort);
      ASSERT_EQ(levels.size(), counts.size());
      for (std::size_t i = 0; i < counts.size(); ++i) {
        EXPECT_LE(levels[i].mesh.faces.size(), counts[i]);
        EXPECT_GE(levels[i].mesh.faces.size(), counts[i] - 10);
      }
    }
  }
}

TEST(TwoSidedSheet, HasALevelOfOneFace) {
  // Without backs the second target is no face at all.
  const auto levels = simplify_to_levels(half_sheet(), {DecimateTarget::faces(50), DecimateTarget::faces(1)});
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_LE(levels[0].mesh.faces.size(), 50U);
  EXPECT_LE(levels[1].mesh.faces.size(), 2U);
}

// Attributes ----------------------------------------------------------------------------------------------------------

/// A sheet with wedges for either side: normals up and down, u = x in front and u = 20 − x behind, colours.
IndexedMesh painted_sheet() {
  IndexedMesh mesh = with_backs(noisy_grid(20, 20, 0.05, 5));
  const std::size_t n = mesh.positions.size();
  Attribute u{.name = "u", .kind = AttributeKind::texcoord, .n_components = 2};
  for (const bool is_back : {false, true}) {
    for (const Vec3& p : mesh.positions) {
      mesh.normals.push_back({0, 0, is_back ? -1.0F : 1.0F});
      mesh.colors.push_back(is_back ? Color{1, 0, 0, 1} : Color{0, 0, 1, 1});
      u.values.push_back(is_back ? 20 - p.x() : p.x());
      u.values.push_back(p.y());
    }
  }
  mesh.attributes.push_back(u);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::size_t first = f < mesh.faces.size() / 2 ? 0 : n;
    for (const Index v : mesh.faces[f]) mesh.wedges.push_back(static_cast<Index>(first + v));
    mesh.face_groups.push_back(f < mesh.faces.size() / 2 ? 0 : 1);
  }
  mesh.group_names = {"front", "back"};
  return mesh;
}

TEST(TwoSidedSheet, KeepsTheAttributesOfBothSides) {
  for (const Effort effort : all_efforts) {
    const IndexedMesh mesh = simplify(painted_sheet(), DecimateTarget::faces(200), effort).mesh;
    ASSERT_GE(mesh.faces.size(), 190U);
    expect_two_sides_everywhere(mesh, "painted");
    ASSERT_EQ(mesh.attributes.size(), 1U);
    EXPECT_EQ(mesh.group_names.size(), 2U);
    std::size_t n_backs = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const bool is_back = mesh.face_groups[f] == 1;
      n_backs += is_back ? 1 : 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Index w = mesh.wedge(f, k);
        const Vec3& p = mesh.positions[mesh.faces[f][k]];
        EXPECT_EQ(mesh.normals[w][2], is_back ? -1 : 1);
        EXPECT_EQ(mesh.colors[w], (is_back ? Color{1, 0, 0, 1} : Color{0, 0, 1, 1}));
        EXPECT_NEAR(mesh.attributes[0].value(w)[0], is_back ? 20 - p.x() : p.x(), 1e-4);
        EXPECT_NEAR(mesh.attributes[0].value(w)[1], p.y(), 1e-4);
      }
    }
    EXPECT_EQ(n_backs, mesh.faces.size() / 2);
  }
}

TEST(TwoSidedSheet, HasOppositeNormalsOnBothSidesWhereTheyAreComputedAnew) {
  IndexedMesh shared = hills_with_backs();
  shared.normals.assign(shared.positions.size(), {0, 0, 1});
  for (const IndexedMesh& input : {painted_sheet(), shared}) {
    SimplifyOptions options;
    options.decimate.normals = Normals::recompute;
    const IndexedMesh mesh = simplify(input, DecimateTarget::faces(200), Effort::normal, options).mesh;
    ASSERT_FALSE(mesh.normals.empty());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      const Vec3 of_face = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(mesh.normals[mesh.wedge(f, k)][2] * of_face.z(), 0);
    }
  }
}

TEST(TwoSidedSheet, HasBordersWhereGroupsOfEitherSideChange) {
  IndexedMesh mesh = hills_with_backs();
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const bool is_back = f >= mesh.faces.size() / 2;
    const bool is_left =
        std::all_of(mesh.faces[f].begin(), mesh.faces[f].end(), [&](Index v) { return mesh.positions[v].x() <= 10; });
    mesh.face_groups.push_back(is_back && is_left ? 1 : 0);
  }
  mesh.group_names = {"all", "left of the back"};
  const IndexedMesh small = simplify(mesh, DecimateTarget::faces(200)).mesh;
  std::size_t n_left = 0;
  for (std::size_t f = 0; f < small.faces.size(); ++f) {
    Vec3 center = Vec3::Zero();
    for (const Index v : small.faces[f]) center += small.positions[v] / 3;
    if (small.face_groups[f] == 1) {
      ++n_left;
      EXPECT_LT(center.x(), 10.1);
    }
  }
  EXPECT_GT(n_left, 20U);
}

TEST(TwoSidedSheet, OfOneAttributeAVertexKeepsIt) {
  IndexedMesh mesh = hills_with_backs();
  Attribute x{.name = "x"};
  for (const Vec3& p : mesh.positions) x.values.push_back(p.x());
  mesh.attributes.push_back(x);
  const IndexedMesh small = simplify(mesh, DecimateTarget::faces(200)).mesh;
  EXPECT_TRUE(small.wedges.empty());
  for (Index v = 0; v < small.positions.size(); ++v) {
    EXPECT_NEAR(small.attributes[0].values[v], small.positions[v].x(), 1e-4);
  }
}

}  // namespace
}  // namespace whittle::test
