#include "whittle/engine/formula/memoryless_term.hh"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "complex/triangle_complex.hh"
#include "oracle/brute_force_memoryless.hh"
#include "support/face_list.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"
#include "whittle/engine/formula/merged_ring.hh"
#include "whittle/metrics/distance.hh"

namespace whittle::test {
namespace {

Eigen::Matrix3d dense(const SymmetricMatrix& m) {
  Eigen::Matrix3d result;
  result << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return result;
}

double largest_entry(const SymmetricMatrix& m) { return dense(m).cwiseAbs().maxCoeff(); }

double largest_difference(const SymmetricMatrix& a, const SymmetricMatrix& b) {
  return (dense(a) - dense(b)).cwiseAbs().maxCoeff();
}

// The step that keeps the volume

/// Planes and volume of a few random faces. Each has one corner near the origin.
struct RandomStep {
  explicit RandomStep(std::uint64_t seed) {
    Random random(seed);
    const double thinness = std::pow(10, random.uniform(-6, 0));  // from flat ground to any shape
    for (int i = 0; i < 8; ++i) {
      std::array<Vec3, 3> face;
      for (Vec3& p : face) p = random.uniform_vector(-1, 1).cwiseProduct(Vec3(1, 1, thinness));
      face[0] = 0.1 * face[0];
      Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]);
      if (normal.z() < 0) normal = -normal;
      planes += SymmetricMatrix::outer(normal.normalized(), 0.5 * normal.norm());
      volume.normal += normal;
      volume.offset += normal.dot(face[0]);
      volume.length += normal.norm();
    }
    volume.farthest_sq = 2;
  }
  SymmetricMatrix planes;
  StarVolume volume;
};

TEST(MemorylessFactor, IsARootOfAnAreaThatRoundingMayLeaveNegative) {
  EXPECT_EQ(memoryless_factor(3.5, 0.25), 2);
  EXPECT_EQ(memoryless_factor(0.0, 0.0), 0);
  EXPECT_EQ(memoryless_factor(-1e-20, 0.0), 0);
}

TEST(VolumeStep, KeepsTheVolume) {
  int n_steps = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto [planes, volume] = RandomStep(seed);
    const Vec3 step = volume_step(planes, volume);
    const double rounding = 1e-14 * volume.length * (1 + step.norm());
    if (step.isZero(0)) continue;
    ++n_steps;
    ASSERT_NEAR(volume.normal.dot(step), volume.offset, rounding) << "seed " << seed;
  }
  EXPECT_GT(n_steps, 900);
}

/// min xᵀ (A + 0.01 tr(A) I) x with g · x = h, by Lagrange multipliers.
TEST(VolumeStep, IsToTheConstrainedMinimumOfTheDampedQuadric) {
  int n_steps = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const auto [planes, volume] = RandomStep(seed);
    Eigen::Matrix4d equations = Eigen::Matrix4d::Zero();
    equations.topLeftCorner<3, 3>() = dense(planes) + 0.01 * planes.trace() * Eigen::Matrix3d::Identity();
    equations.topRightCorner<3, 1>() = volume.normal;
    equations.bottomLeftCorner<1, 3>() = volume.normal.transpose();
    const Vec3 expected = equations.fullPivLu().solve(Eigen::Vector4d(0, 0, 0, volume.offset)).head<3>();
    const Vec3 step = volume_step(planes, volume);
    if (expected.squaredNorm() > 1.999) continue;
    ++n_steps;
    ASSERT_LE((step - expected).norm(), 1e-11 * expected.norm()) << "seed " << seed;
  }
  EXPECT_GT(n_steps, 900);
}

TEST(VolumeStep, IsNoneWhereNormalsCancel) {
  const SymmetricMatrix planes = SymmetricMatrix::identity(1);
  const auto step = [&](double normal) { return volume_step(planes, {{normal, 0, 0}, 0.1 * normal, 1, 1}); };
  EXPECT_EQ(step(0), Vec3(0, 0, 0));
  EXPECT_EQ(step(0.0099), Vec3(0, 0, 0));
  EXPECT_NEAR(step(0.0101).x(), 0.1, 1e-15);
  EXPECT_EQ(volume_step(planes, {}), Vec3(0, 0, 0));
}

TEST(VolumeStep, IsNoneBeyondTheFarthestNeighbour) {
  const SymmetricMatrix planes = SymmetricMatrix::identity(1);
  const auto step = [&](double offset) { return volume_step(planes, {{1, 0, 0}, offset, 1, 4}); };
  EXPECT_NEAR(step(1.99).x(), 1.99, 1e-14);
  EXPECT_EQ(step(2.01), Vec3(0, 0, 0));
}

// Sums over the faces around a pair

/// Vertices 0 and 1, each with the given number of faces that the other doesn't have, in a ring at random heights.
IndexedMesh two_fans(Index n_first, Index n_second, std::uint64_t seed) {
  Random random(seed);
  const Index n = n_first + n_second;
  IndexedMesh mesh;
  mesh.positions = {random.uniform_vector(-0.2, 0.2), random.uniform_vector(-0.2, 0.2)};
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    mesh.positions.push_back(Vec3(std::cos(angle), std::sin(angle), 0) + random.uniform_vector(-0.3, 0.3));
  }
  for (Index i = 0; i < n; ++i) mesh.faces.push_back({i < n_first ? 0U : 1U, 2 + i, 2 + (i + 1) % n});
  mesh.faces.push_back({0, 1, 2});
  mesh.faces.push_back({1, 0, 2 + n_first});
  return mesh;
}

/// The ring of (0, 1) as the complex has it.
struct FoundRing {
  FoundRing(const IndexedMesh& mesh, const Vec3& origin) : complex(mesh.positions, mesh.faces, Frame{}, 1) {
    complex.connect({}, 1);
    for (Index v = 0; v < mesh.positions.size(); ++v) vertex_of[complex.origin(v)] = v;
    ContractionProfile profile;
    complex.gather({0, vertex_of[0], vertex_of[1]}, profile);
    const auto first = profile.first.neighbours();
    const auto second = profile.second.neighbours();
    for (const Neighbour& neighbour : first) ring.around().push_back(neighbour.vertex);
    for (std::size_t i = 1; i + 1 < second.size(); ++i) ring.around().push_back(second[i].vertex);
    ring.look(complex.position(vertex_of[0]), complex.position(vertex_of[1]), first.size() - 1, origin,
              [this](Index v) -> const Vec3& { return complex.position(v); });
  }
  Index origin(std::size_t i) const { return complex.origin(ring.vertex(i)); }

  std::map<Index, Index> vertex_of;
  TriangleComplex complex;
  MergedRing ring;
};

class MergedRingSums : public testing::Test {
 protected:
  template <class Check>
  static void for_each_pair_of_fans(const Check& check) {
    for (Index n_first = 1; n_first <= 20; ++n_first) {
      for (Index n_second = 1; n_second <= 20; ++n_second) {
        if (n_first + n_second < 3) continue;
        SCOPED_TRACE(std::to_string(n_first) + " and " + std::to_string(n_second) + " faces");
        check(two_fans(n_first, n_second, 100 * n_first + n_second));
        if (HasFatalFailure()) return;
      }
    }
  }
  /// The planes of the faces at `v`, after 0 and 1 have become one at `apex`, less those before.
  static SymmetricMatrix change_at(const IndexedMesh& mesh, Index v, const Vec3& apex) {
    SymmetricMatrix before;
    SymmetricMatrix after;
    for (const Triangle& face : mesh.faces) {
      if (!has(face, v)) continue;
      const auto& [a, b, c] = face;
      before += corner_quadric(mesh.positions[a], mesh.positions[b], mesh.positions[c], {});
      if (has(face, 0) && has(face, 1)) continue;
      const auto at = [&](Index w) { return w < 2 ? apex : mesh.positions[w]; };
      after += corner_quadric(at(a), at(b), at(c), {});
    }
    after -= before;
    return after;
  }
  const Vec3 origin_{0.05, -0.02, 0.1};
  const Vec3 apex_{0.1, 0.07, -0.2};
};

TEST_F(MergedRingSums, OfVolumesAreThoseOverTheFaces) {
  for_each_pair_of_fans([&](const IndexedMesh& mesh) {
    const StarVolume found = FoundRing(mesh, origin_).ring.volume();
    StarVolume expected;
    for (const auto& [a, b, c] : mesh.faces) {
      const Vec3& p = mesh.positions[a];
      const Vec3 normal = (mesh.positions[b] - p).cross(mesh.positions[c] - p);
      expected.normal += normal;
      expected.offset += normal.dot(p - origin_);
      expected.length += normal.norm();
    }
    for (std::size_t v = 2; v < mesh.positions.size(); ++v) {
      expected.farthest_sq = std::max(expected.farthest_sq, (mesh.positions[v] - origin_).squaredNorm());
    }
    ASSERT_LE((found.normal - expected.normal).norm(), 1e-14 * expected.length);
    ASSERT_NEAR(found.offset, expected.offset, 1e-14 * expected.length);
    ASSERT_NEAR(found.length, expected.length, 1e-14 * expected.length);
    ASSERT_NEAR(found.farthest_sq, expected.farthest_sq, 1e-15);
  });
}

TEST_F(MergedRingSums, OfPlanesAreThoseOverTheFacesMoved) {
  for_each_pair_of_fans([&](const IndexedMesh& mesh) {
    FoundRing found(mesh, origin_);
    ASSERT_EQ(found.ring.size(), mesh.positions.size() - 2);
    found.ring.move_to(apex_, {});
    const SymmetricMatrix& sum = found.ring.planes();
    SymmetricMatrix expected;
    for (const auto& [end, x, y] : mesh.faces) {
      if (x >= 2 && y >= 2) expected += corner_quadric(apex_, mesh.positions[x], mesh.positions[y], {});
    }
    ASSERT_LE(largest_difference(sum, expected), 1e-14 * largest_entry(expected));
    for (std::size_t i = 0; i < found.ring.size(); ++i) {
      ASSERT_LE(largest_difference(found.ring.change(i), change_at(mesh, found.origin(i), apex_)), 1e-14) << i;
    }
  });
}

/// The oracle sums one at a time, the engine four at a time.
TEST_F(MergedRingSums, HaveThePromisedOrder) {
  for_each_pair_of_fans([&](const IndexedMesh& mesh) {
    FoundRing found(mesh, origin_);
    const FacesAroundPair expected(mesh.positions, mesh.faces, 0, 1, origin_);
    const StarVolume volume = found.ring.volume();
    ASSERT_EQ(volume.normal, expected.volume().normal);
    ASSERT_EQ(volume.offset, expected.volume().offset);
    ASSERT_EQ(volume.length, expected.volume().length);
    ASSERT_EQ(volume.farthest_sq, expected.volume().farthest_sq);
    ASSERT_EQ(found.ring.displacement_sq(apex_), expected.displacement_sq(apex_ - origin_));
    found.ring.move_to(apex_, {});
    ASSERT_EQ(largest_difference(found.ring.planes(), expected.planes(apex_ - origin_, {})), 0);
    for (std::size_t i = 0; i < found.ring.size(); ++i) {
      const SymmetricMatrix change =
          change_of_planes(mesh.positions, mesh.faces, 0, 1, found.origin(i), apex_, origin_, {});
      ASSERT_EQ(largest_difference(found.ring.change(i), change), 0) << i;
    }
  });
}

// Whole runs

Decimation memoryless(const IndexedMesh& mesh, std::uint64_t n_faces, Order order = Order::automatic) {
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.order = order;
  options.keep_quadrics = true;
  return decimate(mesh, DecimateTarget::faces(n_faces), options);
}

/// Sum of planes of the faces at v in the result.
SymmetricMatrix planes_at(Index v, const Decimation& d) {
  SymmetricMatrix sum;
  for (const Triangle& face : d.mesh.faces) {
    if (!has(face, v)) continue;
    const auto at = [&](std::size_t corner) { return d.quadrics[face[corner]].position; };
    sum += corner_quadric(at(0), at(1), at(2), {});
  }
  return sum;
}

/// Holds at inner vertices after any number of contractions beside them, also beside a border.
TEST(Memoryless, PlanesAreThoseOfTheFacesThereAre) {
  std::vector<NamedMesh> meshes = closed_meshes();
  for (NamedMesh& open : open_meshes()) {
    if (topology(open.mesh).misoriented_edges == 0) meshes.push_back(std::move(open));
  }
  meshes.push_back({"noisy_sphere(3)", noisy_sphere(3, 0.03, 3)});
  meshes.push_back({"noisy_grid(40, 20)", noisy_grid(40, 20, 0.3, 3)});
  std::size_t n_vertices = 0;
  for (const auto& [name, mesh] : meshes) {
    for (const std::size_t share : {std::size_t{2}, std::size_t{5}, std::size_t{20}}) {
      SCOPED_TRACE(name + ", 1/" + std::to_string(share) + " of the faces");
      const Decimation d = memoryless(mesh, mesh.faces.size() / share);
      for (Index v = 0; v < d.quadrics.size(); ++v) {
        if (link_of(v, d.mesh.faces).vertices.contains(invalid_index)) continue;  // at a border
        const SymmetricMatrix expected = planes_at(v, d);
        ASSERT_LE(largest_difference(d.quadrics[v].quadric.a, expected), 1e-9 * largest_entry(expected)) << v;
        ++n_vertices;
      }
    }
  }
  EXPECT_GT(n_vertices, 2000U);
}

/// Planes would become negative if a vertex lost planes that it doesn't have.
TEST(Memoryless, PlanesAreNeverLessThanNone) {
  const IndexedMesh sphere = noisy_sphere(3, 0.1, 1);
  const std::vector<NamedMesh> meshes{
      {"noisy_grid", noisy_grid(30, 20, 0.3, 3)},
      {"soup", soup(noisy_sphere(2, 0.1, 2))},
      {"spheres that overlap", joined(sphere, moved(noisy_sphere(3, 0.1, 2), {1.7, 0, 0}))},
      {"spheres that touch", joined(sphere, moved(noisy_sphere(3, 0.1, 2), {2, 0, 0}))},
      {"book", book(11, 4)}};
  DecimateOptions options;
  options.cost = Cost::memoryless;
  options.topology = whittle::Topology::free;
  options.keep_quadrics = true;
  options.pairs.threshold = 0.3;
  for (const auto& [name, mesh] : meshes) {
    for (std::uint64_t n_faces = mesh.faces.size() - 10; n_faces > 20; n_faces = n_faces * 9 / 10) {
      for (const PlacedQuadric& vertex : decimate(mesh, DecimateTarget::faces(n_faces), options).quadrics) {
        const Eigen::Matrix3d a = dense(vertex.quadric.a);
        const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(a).eigenvalues()[0];
        EXPECT_GE(least, -1e-12 * a.trace()) << name << ", " << n_faces << " faces";
        if (HasFailure()) break;
      }
    }
  }
}

/// A sphere of radius 1 with a needle of length 1, 0.004 thick at its foot. It is made of the faces near the pole.
IndexedMesh sphere_with_needle(std::uint64_t seed) {
  IndexedMesh mesh = noisy_sphere(5, 0.02, seed);
  constexpr double foot = 0.1;
  for (Vec3& p : mesh.positions) {
    const double share = 1 - std::atan2(std::hypot(p.x(), p.y()), p.z()) / foot;
    if (share > 0) p = {0.02 * p.x(), 0.02 * p.y(), p.z() + share};
  }
  return mesh;
}

double highest(const IndexedMesh& mesh) {
  double z = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : mesh.positions) z = std::max(z, p.z());
  return z;
}

/// Plain quadrics remove two thirds of the needle at a tenth of the faces.
TEST(Memoryless, KeepsANeedle) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const IndexedMesh mesh = sphere_with_needle(seed);
    const double top = highest(mesh);
    EXPECT_LT(highest(decimate(mesh, DecimateTarget::faces(mesh.faces.size() / 10)).mesh), top - 0.5);
    for (const Order order : {Order::automatic, Order::exact}) {
      for (const std::uint64_t share : {10U, 40U}) {
        const Decimation d = memoryless(mesh, mesh.faces.size() / share, order);
        EXPECT_NEAR(highest(d.mesh), top, 0.1) << "1/" << share << " of the faces, seed " << seed;
      }
    }
  }
}

/// The volume step is refused where a face would turn too far; that is rare here.
TEST(Memoryless, KeepsTheVolumeOfAClosedSurface) {
  for (const auto& [name, mesh] : {NamedMesh{"noisy_sphere", noisy_sphere(4, 0.03, 3)},
                                   NamedMesh{"noisy_torus", noisy_torus(60, 30, 1, 0.35, 0.02, 5)}}) {
    const std::uint64_t n_faces = mesh.faces.size() / 10;
    const double before = signed_volume(mesh);
    EXPECT_NEAR(signed_volume(memoryless(mesh, n_faces).mesh), before, 1e-12 * before) << name;
    EXPECT_LT(signed_volume(decimate(mesh, DecimateTarget::faces(n_faces)).mesh), 0.995 * before) << name;
  }
}

TEST(SlowMemoryless, ErrsLessThanPlainQuadrics) {
  for (const auto& [name, mesh] : {NamedMesh{"noisy_torus", noisy_torus(160, 80, 1, 0.35, 0.01, 5)},
                                   NamedMesh{"blob", blob(5, 5)}, NamedMesh{"knot", knot(400, 40)}}) {
    const DecimateTarget target = DecimateTarget::faces(mesh.faces.size() / 10);
    const auto error_of = [&, &mesh = mesh](const IndexedMesh& result) {
      return metrics::surface_distance(mesh, result, {.samples = 100'000}).mean;
    };
    const double ratio = error_of(memoryless(mesh, *target.n_faces()).mesh) / error_of(decimate(mesh, target).mesh);
    std::cout << name << ": mean error x " << ratio << "\n";
    EXPECT_LE(ratio, 0.9) << name;
  }
}

/// In the default order only a part of the contractions is in order of cost. The result is hardly worse.
TEST(Memoryless, IsNearlyAsGoodInTheDefaultOrder) {
  const IndexedMesh mesh = blob(5, 5);
  const auto error_in = [&](Order order) {
    const Decimation d = memoryless(mesh, mesh.faces.size() / 10, order);
    return metrics::surface_distance(mesh, d.mesh, {.samples = 100'000}).mean;
  };
  const double ratio = error_in(Order::automatic) / error_in(Order::exact);
  std::cout << "mean error x " << ratio << "\n";
  EXPECT_NE(ratio, 1);
  EXPECT_LE(ratio, 1.06);
}

/// The least cost at thin parts rises as faces vanish. Among many equal parts that would put off all pairs after each
/// contraction, if it didn't rise in steps.
TEST(Memoryless, PutsPairsOfManyEqualPartsOffNowAndThen) {
  IndexedMesh mesh = cube();
  for (int i = 0; i < 11; ++i) {  // twice as many, side by side
    const double width = std::ldexp(2, i);
    mesh = joined(mesh, moved(mesh, Vec3(width, 0, 0)));
  }
  const std::uint64_t n_pairs = 3 * mesh.faces.size() / 2;
  constexpr std::uint64_t turns_per_call = 2048;
  for (const Order order : {Order::exact, Order::approximate}) {
    std::uint64_t n_calls = 0;
    DecimateOptions options;
    options.cost = Cost::memoryless;
    options.order = order;
    options.progress = [&n_calls](const Progress&) {
      ++n_calls;
      return true;
    };
    const Decimation d = decimate(mesh, DecimateTarget::as_far_as_possible(), options);
    EXPECT_EQ(d.mesh.faces.size(), mesh.faces.size() / 3) << "a tetrahedron of each";
    EXPECT_LE(n_calls * turns_per_call, 100 * n_pairs);
  }
}

TEST(Memoryless, RefusesWhatItDoesNotGoWith) {
  const auto run = [](auto change) {
    DecimateOptions options;
    options.cost = Cost::memoryless;
    change(options);
    return decimate(cube(), DecimateTarget::as_far_as_possible(), options);
  };
  EXPECT_THROW(run([](DecimateOptions& o) { o.quadric.weights = Weights::uniform; }), std::invalid_argument);
  EXPECT_THROW(run([](DecimateOptions& o) { o.quadric.weights = Weights::area_angle; }), std::invalid_argument);
  EXPECT_THROW(run([](DecimateOptions& o) { o.isotropy = 0.5; }), std::invalid_argument);
  EXPECT_THROW(run([](DecimateOptions& o) {
                 o.pairs.threshold = 1;
                 o.order = Order::exact;
               }),
               std::invalid_argument);
  EXPECT_NO_THROW(run([](DecimateOptions& o) { o.pairs.threshold = 1; }));
}

}  // namespace
}  // namespace whittle::test
