// Decimation that makes no faces intersect. metrics::self_intersections, which is exact, judges the results.
#include <gtest/gtest.h>

#include "guard/face_boxes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

std::size_t n_intersections(const IndexedMesh& mesh) { return metrics::self_intersections(mesh).size(); }

/// Unit spheres on a cubic lattice, turned at random, with a narrow gap between neighbours.
IndexedMesh packed_spheres(int n_side, int levels, double gap, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh all;
  for (int i = 0; i < n_side * n_side * n_side; ++i) {
    IndexedMesh one = sphere(levels);
    const Vec3 axis = random.uniform_vector(-1, 1).normalized();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(random.uniform(0, 3), axis).toRotationMatrix();
    const Vec3 center = (2 + gap) * Vec3(i % n_side, i / n_side % n_side, i / (n_side * n_side));
    for (Vec3& p : one.positions) p = turn * p + center;
    all = all.positions.empty() ? one : joined(all, one);
  }
  return all;
}

/// Two hilly sheets, one closely above the other.
IndexedMesh close_sheets(std::uint64_t seed) {
  const IndexedMesh below = terrain(24, seed);
  IndexedMesh above = below;
  for (Vec3& p : above.positions) p.z() += 0.005;
  return joined(below, above);
}

TEST(SlowIntersectionGuard, KeepsPartsApart) {
  std::size_t n_without = 0;
  std::uint64_t n_refused = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const IndexedMesh& mesh : {packed_spheres(2, 2, 0.002, seed), close_sheets(seed)}) {
      ASSERT_EQ(n_intersections(mesh), 0U);
      for (const Effort effort : {Effort::fast, Effort::normal, Effort::best}) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", effort " + std::to_string(static_cast<int>(effort)));
        const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 5);
        SimplifyOptions options;
        n_without += n_intersections(simplify(mesh, target, effort, options).mesh);
        options.decimate.refuse_intersections = true;
        const Simplification kept = simplify(mesh, target, effort, options);
        EXPECT_EQ(n_intersections(kept.mesh), 0U);
        n_refused += kept.result.refusals[Refusal::intersection];
        EXPECT_LE(kept.mesh.faces.size(), mesh.faces.size() / 2);
      }
    }
  }
  EXPECT_GT(n_without, 100U) << "the meshes are too easy";
  EXPECT_GT(n_refused, 100U);
}

/// At each vertex of the lower sheet a face without area, which goes through the upper one.
IndexedMesh with_needles(IndexedMesh sheets) {
  const std::size_t n_below = sheets.positions.size() / 2;
  for (Index v = 0; v < n_below; ++v) {
    const auto tip = static_cast<Index>(sheets.positions.size());
    sheets.positions.insert(sheets.positions.end(), 2, sheets.positions[v] + Vec3(0.001, 0.001, 0.02));
    sheets.faces.push_back({v, tip, tip + 1});
  }
  return sheets;
}

TEST(IntersectionGuard, IsNotMisledByFacesWithoutArea) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const IndexedMesh sheets = close_sheets(seed);
    const auto n_sheet_vertices = static_cast<std::ptrdiff_t>(sheets.positions.size());
    const IndexedMesh mesh = with_needles(sheets);
    ASSERT_EQ(n_intersections(mesh), 0U);
    DecimateOptions options;
    options.refuse_intersections = true;
    options.locked.assign(mesh.positions.size(), 0);
    std::fill(options.locked.begin() + n_sheet_vertices, options.locked.end(), 1);  // the needles' tips
    for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
      options.cost = cost;
      const Decimation result = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 4), options);
      EXPECT_EQ(n_intersections(result.mesh), 0U) << "seed " << seed;
      EXPECT_LT(result.mesh.faces.size(), mesh.faces.size() * 3 / 4);
      EXPECT_GT(result.result.refusals[Refusal::intersection], 10U);
    }
  }
}

TEST(IntersectionGuard, LetsWhatIntersectsAlreadyGetSmaller) {
  IndexedMesh apart = sphere(3);
  for (Vec3& p : apart.positions) p.x() += 1.01;
  const IndexedMesh mesh = joined(sphere(3), apart);
  ASSERT_GT(n_intersections(mesh), 0U);
  DecimateOptions options;
  options.refuse_intersections = true;
  const Decimation result = decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 8), options);
  EXPECT_EQ(result.result.stop, StopReason::target);
}

TEST(IntersectionGuard, MakesNoneOnAnyMesh) {
  for (const auto& [name, mesh] : all_meshes()) {
    SCOPED_TRACE(name);
    if (n_intersections(mesh) > 0) continue;
    for (const Cost cost : {Cost::quadric, Cost::memoryless, Cost::lindstrom_turk}) {
      DecimateOptions options;
      options.cost = cost;
      options.refuse_intersections = true;
      options.max_normal_flip_deg = 89;
      for (const double share : {0.5, 0.1}) {
        const auto n_faces = static_cast<std::uint64_t>(share * static_cast<double>(mesh.faces.size()));
        const Decimation result = decimate(mesh, DecimateTarget::faces(std::max<std::uint64_t>(n_faces, 1)), options);
        EXPECT_EQ(n_intersections(result.mesh), 0U) << to_string(cost) << ' ' << share;
      }
    }
  }
}

TEST(FaceBoxes, FindTheFacesThatABruteForceSearchFinds) {
  const IndexedMesh mesh = blob(3, 4);
  TriangleComplex complex(mesh.positions, mesh.faces, Frame::of_points(mesh.positions), 1);
  complex.connect({}, 1);
  FaceBoxes boxes(complex);
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    FloatBox box(Vec3(random.uniform_vector(-1, 1)).cast<float>());
    box.extend(Vec3(random.uniform_vector(-1, 1)).cast<float>());
    std::vector<Index> found;
    boxes.visit(box, [&](Index v) {
      found.push_back(v);
      return true;
    });
    std::sort(found.begin(), found.end());
    std::vector<Index> expected;
    for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
      FloatBox own;
      const std::span<const Neighbour> pairs = complex.live_pairs(v);
      for (std::size_t k = 0; k < pairs.size(); k += 2) {
        if (std::min(pairs[k].vertex, pairs[k + 1].vertex) < v) continue;
        for (const Index corner : {v, pairs[k].vertex, pairs[k + 1].vertex}) {
          own.extend(complex.position(corner).cast<float>());
        }
      }
      if (own.intersects(box)) expected.push_back(v);
    }
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace whittle::test
