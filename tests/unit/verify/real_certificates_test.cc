// Certificates that the certifier writes, followed by the verifier, which shares no code with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "certificate.hh"
#include "support/brute_distance.hh"
#include "support/meshes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/core/frame.hh"
#include "whittle/metrics/certificate.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

double larger(const metrics::LargestDistances& largest) {
  return std::max(largest.forward.at_most, largest.backward.at_most);
}

/// What is proven of a pair, to a thousandth.
metrics::CertifiedDistances proven_distances(const IndexedMesh& a, const IndexedMesh& b) {
  metrics::CertifiedDistances proven;
  proven.surface = larger(metrics::largest_distances(a, b, 1e-3));
  if (const auto borders = metrics::largest_border_distances(a, b, 1e-3)) proven.borders = larger(*borders);
  return proven;
}

std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> all = all_meshes();
  all.push_back({"fine torus", noisy_torus(96, 48, 1, 0.4, 0.01, 1)});  // several chunks
  all.push_back({"fine terrain", terrain(48, 3)});
  return all;
}

TEST(SlowRealCertificates, Hold) {
  for (const auto& [name, mesh] : meshes()) {
    for (const double share : {0.5, 0.1}) {
      const auto n_faces = static_cast<std::uint64_t>(share * static_cast<double>(mesh.faces.size()));
      const IndexedMesh result = simplify(mesh, DecimateTarget::faces(n_faces)).mesh;
      if (result.faces.empty()) continue;
      const metrics::CertifiedDistances proven = proven_distances(mesh, result);
      for (const double factor : {1.0001, 1.01, 3.0}) {
        SCOPED_TRACE(name + ", " + std::to_string(share) + ", " + std::to_string(factor));
        const metrics::CertifiedDistances at_most{factor * proven.surface + 1e-9, factor * proven.borders + 1e-9};
        const std::optional<std::string> bytes = metrics::make_certificate(mesh, result, at_most);
        ASSERT_TRUE(bytes);
        const verify::Verification verification = verified(mesh, result, *bytes, 2);
        EXPECT_TRUE(verification.holds) << verification.why_not;
        EXPECT_EQ(verification.max_error, at_most.surface);
        EXPECT_EQ(verification.max_error_borders, at_most.borders);
        EXPECT_TRUE(verification.tolerances.empty());
      }
    }
  }
}

/// Columns of rectangles at these places, each cut into two faces, over a square.
IndexedMesh columns(const std::vector<double>& places, std::size_t n_rows) {
  IndexedMesh mesh;
  for (std::size_t row = 0; row <= n_rows; ++row) {
    for (const double x : places)
      mesh.positions.emplace_back(x, static_cast<double>(row) / static_cast<double>(n_rows), 0);
  }
  for (std::size_t row = 0; row < n_rows; ++row) {
    for (std::size_t column = 0; column + 1 < places.size(); ++column) {
      const auto a = static_cast<Index>(row * places.size() + column);
      const auto above = static_cast<Index>(a + places.size());
      mesh.faces.push_back({a, a + 1, above + 1});
      mesh.faces.push_back({a, above + 1, above});
    }
  }
  return mesh;
}

/// The sides of a needle are as good as opposite to each other: what is made of their normals cancels out.
TEST(RealCertificates, HoldForNeedles) {
  Random random(6);
  int n_proven = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const double width = std::pow(10, random.uniform(-11, -4));
    const double height = std::pow(10, random.uniform(-5, -1));
    IndexedMesh a = columns({0, 0.25, 0.5, 1}, 1 + random.below(6));
    IndexedMesh b = columns({0, 0.25, 0.25 + width, 0.5, 1}, 1 + random.below(6));
    for (Vec3& p : b.positions) p += Vec3(0, 0, height) + 0.1 * width * random.uniform_vector(-1, 1);
    const auto seed = static_cast<std::uint64_t>(i);
    a = rotated(a, seed);
    b = rotated(b, seed);
    const double at_most = random.uniform(1.01, 3) * height + width;
    for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)}) {
      const auto bytes = metrics::make_certificate(*first, *second, {at_most});
      if (!bytes) continue;  // it would take too many steps
      ++n_proven;
      const verify::Verification verification = verified(*first, *second, *bytes);
      EXPECT_TRUE(verification.holds) << verification.why_not << ", width " << width << ", limit " << at_most;
    }
  }
  EXPECT_GT(n_proven, 400);
}

/// In any order of vertices and faces, and with any faces: other certificates are found, which hold, too.
TEST(RealCertificates, HoldForRandomFaces) {
  Random random(5);
  int n_proven = 0;
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(i);
    const IndexedMesh a = random_faces(1 + random.below(12), random);
    IndexedMesh b = a;
    for (Vec3& p : b.positions) p += random.uniform(0, 0.1) * random.uniform_vector(-1, 1);
    std::vector<double> tolerances;
    if (i % 2 == 0) {
      for (std::size_t v = 0; v < a.positions.size(); ++v) tolerances.push_back(random.uniform(0.1, 0.5));
    }
    const metrics::CertifiedDistances at_most{random.uniform(0.1, 0.3),
                                              i % 3 == 0 ? random.uniform(0.1, 0.5) : infinity};
    const auto bytes = metrics::make_certificate(a, b, at_most, {.threads = 1, .tolerances = tolerances});
    if (!bytes) continue;
    ++n_proven;
    const verify::Verification verification = verified(a, b, *bytes);
    EXPECT_TRUE(verification.holds) << verification.why_not;
    EXPECT_EQ(verification.tolerances, tolerances);
  }
  EXPECT_GT(n_proven, 500);
}

TEST(RealCertificates, AreTheSameForAnyNumberOfThreads) {
  const IndexedMesh mesh = noisy_torus(120, 60, 1, 0.4, 0.01, 5);
  const IndexedMesh result = simplify(mesh, DecimateTarget::faces(1000)).mesh;
  const metrics::CertifiedDistances proven = proven_distances(mesh, result);
  const auto expected = metrics::make_certificate(mesh, result, proven, {.threads = 1});
  ASSERT_TRUE(expected);
  for (const unsigned threads : {2U, 5U}) {
    EXPECT_TRUE(metrics::make_certificate(mesh, result, proven, {.threads = threads}) == expected);
    EXPECT_TRUE(verified(mesh, result, *expected, threads).holds);
  }
  EXPECT_LT(expected->size(), 4 * mesh.faces.size());
}

TEST(RealCertificates, HoldInAnyUnitAndPlace) {
  const IndexedMesh mesh = terrain(24, 3);
  const IndexedMesh result = simplify(mesh, DecimateTarget::faces(200)).mesh;
  for (const double unit : {1e-100, 1e-6, 1.0, 1e9, 1e100}) {
    for (const double offset : {0.0, 1e3}) {
      SCOPED_TRACE(std::to_string(unit) + ", " + std::to_string(offset));
      IndexedMesh a = mesh;
      IndexedMesh b = result;
      for (IndexedMesh* moved : {&a, &b}) {
        for (Vec3& p : moved->positions) p = unit * (p + Vec3(offset, -offset, 2 * offset));
      }
      const auto bytes = metrics::make_certificate(a, b, proven_distances(a, b));
      ASSERT_TRUE(bytes);
      const verify::Verification verification = verified(a, b, *bytes);
      EXPECT_TRUE(verification.holds) << verification.why_not;
    }
  }
}

TEST(RealCertificates, AreNotWrittenOfWhatIsNotSo) {
  const IndexedMesh mesh = noisy_torus(24, 12, 1, 0.4, 0.02, 1);
  const IndexedMesh other = noisy_torus(24, 12, 1, 0.4, 0.02, 2);
  const double largest = proven_distances(mesh, other).surface;
  EXPECT_TRUE(metrics::make_certificate(mesh, other, {largest}));
  EXPECT_FALSE(metrics::make_certificate(mesh, other, {0.99 * largest}));
  IndexedMesh open = mesh;
  open.faces.pop_back();
  EXPECT_TRUE(metrics::make_certificate(mesh, open, {1}));
  EXPECT_FALSE(metrics::make_certificate(mesh, open, {1, 100})) << "a border is infinitely far from none";
  EXPECT_THROW(metrics::make_certificate(mesh, other, {0}), std::invalid_argument);
  EXPECT_THROW(metrics::make_certificate(mesh, other, {1, 0}), std::invalid_argument);
  EXPECT_THROW(metrics::make_certificate(mesh, {}, {1}), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::test
