// What contraction keeps to, polish keeps to as well: tolerances of feature lines, shape, and seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/wedges.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/lines.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

constexpr double sharp_deg = 40;

/// A cube whose edges and sides are bent in waves.
IndexedMesh bent_block(int n, double height = 0.15, double f = 3) {
  IndexedMesh mesh = tessellated_cube(n);
  for (Vec3& p : mesh.positions) {
    p += height * Vec3(std::sin(f * p.y() + p.z()), std::sin(f * p.z() + p.x()), std::sin(f * p.x() + p.y()));
  }
  return mesh;
}

/// Sharp edges, straight and round ones.
std::vector<NamedMesh> cad_shapes() {
  return {{"bent_block(24)", bent_block(24)},
          {"bent_block(24, 0.1, 3)", bent_block(24, 0.1, 3)},
          {"bent_block(24, 0.05, 6)", bent_block(24, 0.05, 6)},
          {"bracket(12)", bracket(12)},
          {"capped_cylinder(160, strip)", capped_cylinder(160, Caps::strip)},
          {"washer(120)", washer(120)},
          {"cone(120)", cone(120)}};
}

/// How far the sharp edges of two meshes are apart, both ways, over the diagonal.
double feature_distance_rel(const IndexedMesh& mesh, const IndexedMesh& small) {
  const auto distance =
      metrics::line_distance(metrics::feature_lines(mesh, sharp_deg), metrics::feature_lines(small, sharp_deg));
  return distance ? distance->max / diagonal_of(mesh.positions) : 0;
}

SimplifyOptions with_features(double tolerance_rel) {
  SimplifyOptions options;
  options.decimate.feature_angle_deg = sharp_deg;
  options.decimate.feature_tolerance = tolerance_rel;
  return options;
}

constexpr double rounding = 1 + 1e-6;

TEST(SlowKeptByPolish, FeatureTolerance) {
  std::size_t n_moved = 0;
  for (const auto& [name, mesh] : cad_shapes()) {
    for (const double tolerance_rel : {0.003, 0.0005}) {
      for (const double ratio : {0.3, 0.1, 0.05}) {
        for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
          const auto n_faces = static_cast<std::uint64_t>(ratio * static_cast<double>(mesh.faces.size()));
          const Simplification s = simplify(mesh, DecimateTarget::faces(n_faces), effort, with_features(tolerance_rel));
          EXPECT_LE(feature_distance_rel(mesh, s.mesh), rounding * tolerance_rel)
              << name << " to " << n_faces << ", effort " << static_cast<int>(effort);
          n_moved += s.polish.n_moved;
        }
      }
    }
  }
  EXPECT_GT(n_moved, 1000U) << "else this tests nothing";
}

TEST(KeptByPolish, FeatureToleranceOfLevelsAndWithinAnError) {
  const IndexedMesh mesh = bent_block(24);
  const double tolerance_rel = 0.001;
  const std::vector<DecimateTarget> targets{DecimateTarget::faces(2000), DecimateTarget::faces(1000),
                                            DecimateTarget::faces(600)};
  for (const Effort effort : {Effort::normal, Effort::best}) {
    for (const Simplification& level : simplify_to_levels(mesh, targets, effort, with_features(tolerance_rel))) {
      EXPECT_LE(feature_distance_rel(mesh, level.mesh), rounding * tolerance_rel);
    }
    const Simplification within = simplify(mesh, DecimateTarget::max_error(0.02 * diagonal_of(mesh.positions)), effort,
                                           with_features(tolerance_rel));
    EXPECT_LE(feature_distance_rel(mesh, within.mesh), rounding * tolerance_rel);
    EXPECT_LT(within.mesh.faces.size(), mesh.faces.size() / 4);
  }
}

/// Polish may bring other meshes than the decimater's: what is further off doesn't get further off.
TEST(KeptByPolish, FeaturesThatWereTooFarOffGetNoFurther) {
  const IndexedMesh mesh = bent_block(24);
  const SimplifyOptions loose = with_features(0.01);
  Decimation d = decimate(mesh, DecimateTarget::faces(400), loose.decimate);
  const double before = feature_distance_rel(mesh, d.mesh);
  ASSERT_GT(before, 0.002);
  const SimplifyOptions strict = with_effort(Effort::best, with_features(0.0005));
  polish_decimation(mesh, strict, d);
  EXPECT_LE(feature_distance_rel(mesh, d.mesh), rounding * before);
}

struct ShapeOptions {
  double isotropy;
  double valence_weight;
};

std::vector<NamedMesh> scan_like() {
  return {{"noisy_sphere", noisy_sphere(5, 0.02, 1)},
          {"noisy_torus", noisy_torus(120, 60, 1, 0.4, 0.02, 3)},
          {"blob", blob(5, 5)},
          {"knot", knot(200, 24)},
          {"terrain", terrain(80, 4)}};
}

TEST(SlowKeptByPolish, RoundTriangles) {
  for (const auto& [name, mesh] : scan_like()) {
    for (const auto& [isotropy, valence_weight] :
         {ShapeOptions{0.5, 0.5}, ShapeOptions{0.2, 0.5}, ShapeOptions{0.5, 0}, ShapeOptions{0.9, 1}}) {
      for (const double ratio : {0.2, 0.05}) {
        SimplifyOptions options;
        options.decimate.isotropy = isotropy;
        options.decimate.valence_weight = valence_weight;
        const auto n_faces = static_cast<std::uint64_t>(ratio * static_cast<double>(mesh.faces.size()));
        const DecimateTarget target = DecimateTarget::faces(n_faces);
        const IndexedMesh fast = simplify(mesh, target, Effort::fast, options).mesh;
        const metrics::Shape shape = metrics::shape(fast);
        const double error = metrics::surface_distance(mesh, fast, {.samples = 20'000}).mean;
        for (const Effort effort : {Effort::normal, Effort::best}) {
          SCOPED_TRACE(name + " to " + std::to_string(n_faces) + ", isotropy " + std::to_string(isotropy) +
                       ", valences " + std::to_string(valence_weight) + ", effort " +
                       std::to_string(static_cast<int>(effort)));
          const IndexedMesh small = simplify(mesh, target, effort, options).mesh;
          const metrics::Shape polished = metrics::shape(small);
          EXPECT_GE(polished.radius_ratio_mean, 0.99 * shape.radius_ratio_mean);
          EXPECT_LE(polished.edge_length_cv, 1.02 * shape.edge_length_cv);
          EXPECT_GE(polished.valence.share_5_to_7, 0.98 * shape.valence.share_5_to_7);
          EXPECT_LE(metrics::surface_distance(mesh, small, {.samples = 20'000}).mean, 1.02 * error);
        }
      }
    }
  }
}

TEST(KeptByPolish, LeastRadiusRatio) {
  for (const auto& [name, mesh] : scan_like()) {
    for (const Effort effort : {Effort::normal, Effort::best}) {
      SimplifyOptions options;
      options.decimate.min_radius_ratio = 0.3;
      const std::size_t n_faces = mesh.faces.size() / 8;
      const double least_before = metrics::shape(mesh).radius_ratio_min;
      const IndexedMesh small = simplify(mesh, DecimateTarget::faces(n_faces), effort, options).mesh;
      EXPECT_GE(metrics::shape(small).radius_ratio_min, std::min(0.3, least_before) - 1e-9)
          << name << ", effort " << static_cast<int>(effort);
    }
  }
}

/// A bent sheet over the unit square, with two regions or two charts that meet at x = 0.5.
IndexedMesh halved_sheet(bool has_charts) {
  constexpr int n = 40;
  IndexedMesh mesh = noisy_grid(n, n, 0, 1);
  for (Vec3& p : mesh.positions) {
    p /= n;
    p.z() = 0.1 * std::sin(7 * p.x() + 2) * std::cos(5 * p.y());
  }
  std::vector<double> side;
  for (const Triangle& face : mesh.faces) {
    const double x = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]).x() / 3;
    side.push_back(x < 0.5 ? 0 : 1);
  }
  if (!has_charts) {
    mesh.face_attributes.push_back({.name = "label",
                                    .kind = AttributeKind::category,
                                    .n_components = 1,
                                    .values = side,
                                    .type = ScalarType::int32});
    return mesh;
  }
  Attribute texture{.name = "TEXCOORD_0", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[mesh.faces[f][k]];
      mesh.wedges.push_back(static_cast<Index>(3 * f + k));
      texture.values.insert(texture.values.end(), {p.x() + 2 * side[f], p.y()});
    }
  }
  mesh.attributes.push_back(texture);
  join_equal_wedges(mesh);
  return mesh;
}

/// How far the seam is from x = 0.5, at most.
double seam_offset(const IndexedMesh& mesh) {
  double most = 0;
  for (const auto& [a, b] : seam_edges(mesh)) {
    for (const Index v : {a, b}) most = std::max(most, std::abs(mesh.positions[v].x() - 0.5));
  }
  return most;
}

TEST(KeptByPolish, SeamsThatAreStraight) {
  for (const bool has_charts : {false, true}) {
    const IndexedMesh mesh = halved_sheet(has_charts);
    ASSERT_LT(seam_offset(mesh), 1e-12);
    ASSERT_EQ(seam_edges(mesh).size(), 40U);
    for (const std::uint64_t n_faces : {800U, 400U, 200U, 100U}) {
      SimplifyOptions contracted;
      contracted.decimate.cost = Cost::memoryless;
      contracted.polish_passes = 0;
      const DecimateTarget target = DecimateTarget::faces(n_faces);
      const double left = seam_offset(simplify(mesh, target, Effort::normal, contracted).mesh);
      for (const Effort effort : {Effort::normal, Effort::best}) {
        const IndexedMesh small = simplify(mesh, target, effort).mesh;
        EXPECT_GT(seam_edges(small).size(), 2U);
        EXPECT_LE(seam_offset(small), std::max(1.1 * left, 2e-3))
            << n_faces << (has_charts ? " charts" : " regions") << ", effort " << static_cast<int>(effort);
      }
    }
  }
}

TEST(KeptByPolish, SeamsOnlyIfTheyCount) {
  const IndexedMesh mesh = halved_sheet(true);
  const DecimateTarget target = DecimateTarget::faces(200);
  SimplifyOptions options;
  options.decimate.attribute_weights.seam = 0;
  options.decimate.feature_tolerance = std::numeric_limits<double>::infinity();
  const double free = seam_offset(simplify(mesh, target, Effort::normal, options).mesh);
  EXPECT_GT(free, 2 * seam_offset(simplify(mesh, target, Effort::normal).mesh));
}

/// Around a leaf no plane holds vertices in place: polish moved some along the sheet.
TEST(KeptByPolish, FoldsOfTwoSidedSheets) {
  const IndexedMesh leaf = two_sided_leaf(40);
  const auto largest = [&leaf](double valence, Effort effort) {
    SimplifyOptions options;
    options.decimate.valence_weight = valence;
    const Simplification s = simplify(leaf, DecimateTarget::faces(leaf.faces.size() / 8), effort, options);
    return metrics::largest_distances(leaf, s.mesh, 1e-2).forward.at_most;
  };
  for (const double valence : {0.0, 1e-12, 0.1}) {
    const double fast = largest(valence, Effort::fast);
    for (const Effort effort : {Effort::normal, Effort::best}) {
      EXPECT_LE(largest(valence, effort), 1.1 * fast) << valence << ", effort " << static_cast<int>(effort);
    }
  }
}

}  // namespace
}  // namespace whittle::test
