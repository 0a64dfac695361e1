// Regions that face attributes name: their borders stay where they were, and none vanishes before it has to.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <vector>

#include "attributes/kept_areas.hh"
#include "support/shapes/shapes.hh"
#include "support/topology.hh"
#include "whittle/core/regions.hh"
#include "whittle/core/wedges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

constexpr int n_cells = 24;

/// Three by three squares.
double region_at(double x, double y) { return std::floor(3 * x / n_cells) + 3 * std::floor(3 * y / n_cells); }

Vec3 middle_of(const IndexedMesh& mesh, const Triangle& face) {
  return (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3;
}

/// A square, flat or with a hill, in nine regions.
IndexedMesh in_regions(double height, const Attribute& attribute) {
  IndexedMesh mesh = noisy_grid(n_cells, n_cells, 0, 1);
  for (Vec3& p : mesh.positions) p.z() = height * std::exp(-(p - Vec3(9, 13, 0)).squaredNorm() / 40);
  Attribute regions = attribute;
  for (const Triangle& face : mesh.faces) {
    const Vec3 middle = middle_of(mesh, face);
    for (std::size_t i = 0; i < regions.n_components; ++i) {
      regions.values.push_back(region_at(middle.x(), middle.y()) / (regions.n_components == 1 ? 1.0 : 10.0));
    }
  }
  mesh.face_attributes.push_back(regions);
  return mesh;
}

std::vector<Attribute> all_attributes() {
  return {
      {.name = "label", .kind = AttributeKind::category, .n_components = 1, .values = {}, .type = ScalarType::int32},
      {.name = "red,green,blue", .kind = AttributeKind::color, .n_components = 3, .values = {}},
      {.name = "scalar_Class", .kind = AttributeKind::scalar, .n_components = 1, .values = {}}};
}

/// Share of the area, seen from above, whose face has the value of another region.
double wrong_share(const IndexedMesh& mesh) {
  constexpr int n_points = 8;  // along each side
  const Attribute& label = mesh.face_attributes.front();
  double wrong = 0;
  double all = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 u = mesh.positions[b] - mesh.positions[a];
    const Vec3 v = mesh.positions[c] - mesh.positions[a];
    const double area = std::abs(u.x() * v.y() - u.y() * v.x());
    for (int i = 0; i < n_points; ++i) {
      for (int j = 0; i + j < n_points; ++j) {
        const Vec3 p = mesh.positions[a] + ((i + 1.0 / 3) * u + (j + 1.0 / 3) * v) / n_points;
        const double value = region_at(p.x(), p.y()) / (label.n_components == 1 ? 1.0 : 10.0);
        all += area;
        if (value != label.value(f)[0]) wrong += area;
      }
    }
  }
  return wrong / all;
}

TEST(Regions, KeepTheirBordersUnderAllCostsAndEfforts) {
  for (const double height : {0.0, 4.0}) {
    for (const Attribute& attribute : all_attributes()) {
      const IndexedMesh mesh = in_regions(height, attribute);
      ASSERT_EQ(wrong_share(mesh), 0);
      for (const CostTraits& traits : all_cost_traits) {
        const Cost cost = traits.cost;
        for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
          SimplifyOptions options;
          options.decimate.cost = cost;
          const Simplification small = simplify(mesh, DecimateTarget::faces(64), effort, options);
          EXPECT_EQ(small.result.stop, StopReason::target);
          EXPECT_LT(wrong_share(small.mesh), 0.02) << attribute.name << ", height " << height << ", " << to_string(cost)
                                                   << ", effort " << static_cast<int>(effort);
        }
      }
    }
  }
}

TEST(Regions, AreThoseThatTheOptionNames) {
  const IndexedMesh mesh = in_regions(0, all_attributes().front());
  DecimateOptions options;
  options.regions.emplace();
  EXPECT_GT(wrong_share(decimate(mesh, DecimateTarget::faces(64), options).mesh), 0.05);
  options.regions->emplace_back("label");
  EXPECT_LT(wrong_share(decimate(mesh, DecimateTarget::faces(64), options).mesh), 0.02);
}

std::set<double> labels_of(const IndexedMesh& mesh) {
  const std::vector<double>& values = mesh.face_attributes.front().values;
  return {values.begin(), values.end()};
}

/// The square with a region of two faces in its middle, and one of two faces at its border.
IndexedMesh with_small_regions(int n) {
  IndexedMesh mesh = noisy_grid(n, n, 0, 1);
  Attribute label = all_attributes().front();
  for (const Triangle& face : mesh.faces) {
    const Vec3 middle = middle_of(mesh, face);
    const auto is_in_cell = [&](int x, int y) {
      return static_cast<int>(std::floor(middle.x())) == x && static_cast<int>(std::floor(middle.y())) == y;
    };
    label.values.push_back(is_in_cell(n / 2, n / 2) ? 1 : is_in_cell(n / 3, 0) ? 2 : 0);
  }
  mesh.face_attributes.push_back(label);
  return mesh;
}

TEST(Regions, VanishOnlyWhereTheTargetHasFewFacesForEach) {
  const IndexedMesh mesh = with_small_regions(30);
  for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
    for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
      SimplifyOptions options;
      options.decimate.cost = cost;
      const Simplification kept = simplify(mesh, DecimateTarget::faces(24), effort, options);
      EXPECT_EQ(kept.result.stop, StopReason::target);
      EXPECT_EQ(labels_of(kept.mesh).size(), 3U);
      const Simplification least = simplify(mesh, DecimateTarget::faces(2), effort, options);
      EXPECT_EQ(least.result.stop, StopReason::target);
      EXPECT_LE(least.mesh.faces.size(), 2U);
    }
  }
}

TEST(Regions, AreKeptByTheirSize) {
  const IndexedMesh mesh = with_small_regions(30);
  const KeptAreas areas(mesh, seam_areas(mesh, seam_edges(mesh, face_regions(mesh))));
  const auto n_kept = [&areas](const DecimateTarget& target) {
    std::set<Index> kept;
    for (const Index area : areas.of(target)) kept.insert(area);
    kept.erase(invalid_index);
    return kept.size();
  };
  EXPECT_EQ(n_kept(DecimateTarget::faces(7)), 0U);
  EXPECT_EQ(n_kept(DecimateTarget::faces(8)), 1U);
  EXPECT_EQ(n_kept(DecimateTarget::vertices(8)), 2U);
  EXPECT_EQ(n_kept(DecimateTarget::faces(100)), 3U);
  EXPECT_EQ(n_kept(DecimateTarget::max_cost(1)), 3U);
  const std::vector<Index> largest = areas.of(DecimateTarget::faces(8));
  for (std::size_t f = 0; f < largest.size(); ++f) {
    EXPECT_EQ(largest[f] != invalid_index, mesh.face_attributes[0].values[f] == 0) << f;
  }
}

TEST(Regions, KeepALastFaceInBlocksOnAnyNumberOfThreads) {
  const IndexedMesh mesh = with_small_regions(300);
  DecimateOptions options;
  options.cost = Cost::memoryless;
  const DecimateTarget target = DecimateTarget::faces(200);
  ASSERT_TRUE(goes_in_blocks(mesh, target, options));
  options.threads = 1;
  const Decimation alone = decimate(mesh, target, options);
  EXPECT_EQ(labels_of(alone.mesh).size(), 3U);
  options.threads = 3;
  const Decimation shared = decimate(mesh, target, options);
  EXPECT_EQ(shared.mesh.positions, alone.mesh.positions);
  EXPECT_EQ(shared.mesh.faces, alone.mesh.faces);
}

TEST(Regions, ChartsKeepALastFace) {
  const IndexedMesh mesh = tiled_torus(60, 30, 3);
  const std::vector<Index> areas = seam_areas(mesh, seam_edges(mesh));
  const std::size_t n_charts = std::set<Index>(areas.begin(), areas.end()).size();
  for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
    DecimateOptions options;
    options.cost = cost;
    const Decimation d = decimate(mesh, DecimateTarget::faces(2 * n_charts), options);
    EXPECT_EQ(d.result.stop, StopReason::target);
    std::set<Index> left;
    for (const Index f : d.face_origins) left.insert(areas[f]);
    EXPECT_EQ(left.size(), n_charts);
    const Decimation fewer = decimate(mesh, DecimateTarget::faces(n_charts / 2), options);
    EXPECT_EQ(fewer.result.stop, StopReason::target);
  }
}

}  // namespace
}  // namespace whittle::test
