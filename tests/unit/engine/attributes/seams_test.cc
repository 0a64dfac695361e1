// Meshes with charts and materials: seams stay closed and in place, attributes stay near those of the input.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/topology.hh"
#include "whittle/core/wedges.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

IndexedMesh with_joined_wedges(IndexedMesh mesh) {
  join_equal_wedges(mesh);
  return mesh;
}

std::vector<std::pair<Cost, Seams>> all_costs_and_seams() {
  std::vector<std::pair<Cost, Seams>> all;
  for (const CostTraits& traits : all_cost_traits) {
    for (const Seams seams : {Seams::weighted, Seams::keep}) all.emplace_back(traits.cost, seams);
  }
  return all;
}

/// How far texture coordinates of a tiled torus go beyond their charts, in charts; infinite if a face has two charts.
double bleeding(const IndexedMesh& mesh) {
  double farthest = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t i = 0; i < 2; ++i) {
      std::array<double, 3> at{};
      for (std::size_t k = 0; k < 3; ++k) at[k] = mesh.attributes[0].value(mesh.wedge(f, k))[i];
      const double chart = 10 * std::floor((at[0] + 4.5) / 10);
      for (const double x : at) {
        if (std::abs(x - chart - 0.5) > 4) return std::numeric_limits<double>::infinity();
        farthest = std::max(farthest, std::abs(x - chart - 0.5) - 0.5);
      }
    }
  }
  return farthest;
}

/// The faces of a group.
IndexedMesh group_of(const IndexedMesh& mesh, Index group) {
  IndexedMesh part;
  part.positions = mesh.positions;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (mesh.face_groups[f] == group) part.faces.push_back(mesh.faces[f]);
  }
  return part;
}

TEST(Seams, OfMaterialsStayClosedAndInPlace) {
  const IndexedMesh mesh = with_joined_wedges(charted_cube(8));
  for (const auto& [cost, seams] : all_costs_and_seams()) {
    DecimateOptions options;
    options.cost = cost;
    options.seams = seams;
    const Decimation d = decimate(mesh, DecimateTarget::faces(60), options);
    EXPECT_EQ(d.result.stop, StopReason::target);
    EXPECT_TRUE(topology(d.mesh).manifold() && topology(d.mesh).closed());
    EXPECT_EQ(topology(d.mesh).genus(), 0);
    EXPECT_EQ(d.mesh.group_names, mesh.group_names);
    for (Index side = 0; side < 6; ++side) {
      const IndexedMesh part = group_of(d.mesh, side);
      const Topology shape = topology(part);
      EXPECT_EQ(shape.components, 1);
      EXPECT_EQ(shape.border_loops, 1);
      for (const Triangle& face : part.faces) {
        for (const Index v : face) {
          EXPECT_NEAR(d.mesh.positions[v][side / 2], side % 2 == 1 ? 1 : -1, 1e-8) << "a material bleeds";
        }
      }
    }
  }
}

TEST(Seams, OfManyChartsGiveWayUnlessKept) {
  const IndexedMesh mesh = tiled_torus(60, 30, 3);
  const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 10);
  for (const auto& [cost, seams] : all_costs_and_seams()) {
    DecimateOptions options;
    options.cost = cost;
    options.seams = seams;
    const Decimation d = decimate(mesh, target, options);
    const bool has_planes = cost == Cost::quadric || cost == Cost::memoryless;
    const bool gives_way = has_planes && seams == Seams::weighted;
    EXPECT_EQ(d.result.stop, gives_way ? StopReason::target : StopReason::exhausted);
    EXPECT_TRUE(topology(d.mesh).manifold() && topology(d.mesh).closed());
    EXPECT_EQ(topology(d.mesh).genus(), 1);
    EXPECT_LE(bleeding(d.mesh), 1e-9);
  }
}

TEST(Seams, AreTheFeatureEdgesOfTheResult) {
  for (const IndexedMesh& mesh : {with_joined_wedges(charted_cube(8)), textured_torus(40, 24)}) {
    for (const CostTraits& traits : all_cost_traits) {
      DecimateOptions options;
      options.cost = traits.cost;
      options.seams = Seams::keep;
      const Decimation d = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 8), options);
      EXPECT_EQ(d.result.stop, StopReason::target);
      EXPECT_EQ(seam_edges(d.mesh), d.feature_edges);
    }
  }
}

TEST(Seams, OfAFlatSurfaceKeepTheirShape) {
  const IndexedMesh mesh = disc_in_square(24);
  for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
    for (const Boundary boundary : {Boundary::weighted, Boundary::free}) {
      for (const Seams seams : {Seams::weighted, Seams::keep}) {
        DecimateOptions options;
        options.cost = cost;
        options.boundary = boundary;
        options.seams = seams;
        const Decimation d = decimate(mesh, DecimateTarget::faces(60), options);
        EXPECT_EQ(d.result.stop, StopReason::target);
        EXPECT_NEAR(area_of_disc(d.mesh), area_of_disc(mesh), 0.04 * area_of_disc(mesh));
      }
    }
  }
}

TEST(Seams, AreNotHeldWithoutWeight) {
  const IndexedMesh mesh = disc_in_square(24);
  const auto area_error = [&](double weight) {
    DecimateOptions options;
    options.attribute_weights.seam = weight;
    const Decimation d = decimate(mesh, DecimateTarget::faces(30), options);
    return std::abs(area_of_disc(d.mesh) - area_of_disc(mesh));
  };
  EXPECT_GT(area_error(0), 5 * area_error(1));
}

/// Chart positions are linear on each side, and so are those of the result: the fit can be exact.
TEST(FitAttributes, IsExactWhereBothAreLinear) {
  const IndexedMesh mesh = with_joined_wedges(charted_cube(10));
  for (const std::uint64_t n : {600U, 200U, 40U}) {
    const Simplification s = simplify(mesh, DecimateTarget::faces(n));
    EXPECT_EQ(s.result.stop, StopReason::target);
    for (std::size_t f = 0; f < s.mesh.faces.size(); ++f) {
      const Index side = s.mesh.face_groups[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index w = s.mesh.wedge(f, k);
        const std::array<double, 2> expected = chart_position(side, s.mesh.positions[s.mesh.faces[f][k]]);
        for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(s.mesh.attributes[0].value(w)[i], expected[i], 1e-4);
        for (std::size_t i = 0; i < 3; ++i) {
          const float along = i == side / 2 ? (side % 2 == 1 ? 1.0F : -1.0F) : 0.0F;
          EXPECT_NEAR(s.mesh.normals[w][i], along, 1e-6);
        }
      }
    }
  }
}

/// Mean distance on the surface between a face's middle and where its texture is on the torus.
struct Slip {
  double mean = 0;
  int n_folded = 0;
};
Slip slip_of(const IndexedMesh& mesh) {
  constexpr double turn = 2 * std::numbers::pi;
  Slip slip;
  double area = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 edge = mesh.positions[b] - mesh.positions[a];
    const Vec3 other = mesh.positions[c] - mesh.positions[a];
    Eigen::Matrix<double, 2, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto value = mesh.attributes[0].value(mesh.wedge(f, k));
      uv.col(static_cast<Eigen::Index>(k)) << value[0], value[1];
    }
    const Eigen::Vector2d first = uv.col(1) - uv.col(0);
    const Eigen::Vector2d second = uv.col(2) - uv.col(0);
    slip.n_folded += int{first.x() * second.y() - first.y() * second.x() <= 0};
    const Eigen::Vector2d at = uv.rowwise().mean() * turn;
    const Vec3 there((1 + 0.35 * std::cos(at.y())) * std::cos(at.x()), (1 + 0.35 * std::cos(at.y())) * std::sin(at.x()),
                     0.35 * std::sin(at.y()));
    const double weight = edge.cross(other).norm();
    slip.mean += weight * (there - (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3).norm();
    area += weight;
  }
  slip.mean /= area;
  return slip;
}

TEST(FitAttributes, BringsATextureBackToItsPlace) {
  const IndexedMesh mesh = textured_torus(120, 60);
  for (const double share : {0.2, 0.05}) {
    const auto n = static_cast<std::uint64_t>(share * static_cast<double>(mesh.faces.size()));
    const Simplification fitted = simplify(mesh, DecimateTarget::faces(n));
    const Simplification carried = simplify(mesh, DecimateTarget::faces(n), Effort::fast);
    const Slip slip = slip_of(fitted.mesh);
    EXPECT_EQ(slip.n_folded, 0);
    EXPECT_LT(slip.mean, 0.5 * slip_of(carried.mesh).mean);
    const double area = 4 * std::numbers::pi * std::numbers::pi * 0.35;
    const double edge = std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(n));
    EXPECT_LT(slip.mean, 0.15 * edge);
  }
}

TEST(FitAttributes, GivesTheSameForAnyThreads) {
  const IndexedMesh mesh = textured_torus(60, 30);
  SimplifyOptions options;
  options.decimate.threads = 1;
  const Simplification one = simplify(mesh, DecimateTarget::faces(400), Effort::normal, options);
  options.decimate.threads = 3;
  const Simplification three = simplify(mesh, DecimateTarget::faces(400), Effort::normal, options);
  EXPECT_EQ(one.mesh.wedges, three.mesh.wedges);
  EXPECT_EQ(one.mesh.attributes[0].values, three.mesh.attributes[0].values);
}

}  // namespace
}  // namespace whittle::test
