// Certificates with bytes that were changed, and of meshes that were changed. None that is false may be taken.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certificate.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "whittle/metrics/certificate.hh"
#include "whittle/simplify/simplify.hh"

namespace whittle::test {
namespace {

/// The largest distances that a pair is found to have: less can't be proven.
struct FoundDistances {
  double surface = 0;
  double borders = 0;
};

FoundDistances found_distances(const IndexedMesh& a, const IndexedMesh& b) {
  const auto larger = [](const metrics::LargestDistances& largest) {
    return std::max(largest.forward.at_least, largest.backward.at_least);
  };
  FoundDistances found{larger(metrics::largest_distances(a, b, 1e-3, {.threads = 1})), 0};
  if (const auto borders = metrics::largest_border_distances(a, b, 1e-3, {.threads = 1}))
    found.borders = larger(*borders);
  return found;
}

bool is_true(const verify::Verification& claim, const FoundDistances& found) {
  return claim.max_error >= found.surface && claim.max_error_borders >= found.borders;
}

constexpr std::size_t first_limit = 22;  ///< where the limits are in a certificate
constexpr std::size_t second_limit = 30;

/// A little less, or a little more, or much.
void change_limit(std::string& bytes, double limit, std::size_t at, Random& random) {
  const double factor = random.below(2) == 0 ? random.uniform(0.9, 1.05) : random.uniform(0, 2);
  bytes.replace(at, 8, real_bytes(factor * limit));
}

void change_bytes(std::string& bytes, Random& random) {
  const auto at = static_cast<std::size_t>(random.below(bytes.size()));
  switch (random.below(5)) {
    case 0:
      bytes[at] = static_cast<char>(random.below(256));
      break;
    case 1:
      bytes[at] = static_cast<char>(static_cast<unsigned char>(bytes[at]) ^ (1U << random.below(8)));
      break;
    case 2:
      bytes.erase(at, 1 + random.below(4));
      break;
    case 3:
      bytes.insert(at, 1 + random.below(2), static_cast<char>(random.below(256)));
      break;
    default:
      std::swap(bytes[at], bytes[random.below(bytes.size())]);
  }
}

struct Case {
  IndexedMesh in;
  IndexedMesh out;
  FoundDistances found;
  metrics::CertifiedDistances claimed;
  std::string certificate;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const IndexedMesh& mesh : {sphere(1), noisy_torus(10, 6, 1, 0.4, 0.02, 1), bracket(2), terrain(6, 3),
                                  open_cylinder(10, 4), moebius(12, 2), book(3, 2), noisy_grid(6, 6, 0.05, 1)}) {
    Case c;
    c.in = mesh;
    c.out = simplify(mesh, DecimateTarget::faces(mesh.faces.size() / 3)).mesh;
    c.found = found_distances(c.in, c.out);
    c.claimed = {1.001 * c.found.surface + 1e-6, c.found.borders > 0 ? 1.001 * c.found.borders + 1e-6 : infinity};
    const auto certificate = metrics::make_certificate(c.in, c.out, c.claimed, {.threads = 1});
    EXPECT_TRUE(certificate);
    c.certificate = certificate.value_or("");
    all.push_back(std::move(c));
  }
  return all;
}

TEST(Mutations, OfBytesProveNothingFalse) {
  constexpr int n_mutations = 100'000;
  const std::vector<Case> all = cases();
  Random random(17);
  int n_taken = 0;
  for (int i = 0; i < n_mutations; ++i) {
    const Case& c = all[random.below(all.size())];
    std::string bytes = c.certificate;
    if (i % 2 == 0) change_limit(bytes, c.claimed.surface, first_limit, random);
    if (i % 4 == 1 && c.claimed.borders < infinity) change_limit(bytes, c.claimed.borders, second_limit, random);
    for (std::uint64_t n = random.below(4); n > 0; --n) change_bytes(bytes, random);
    const verify::Verification claim = verified(c.in, c.out, bytes);
    if (!claim.holds) continue;
    ++n_taken;
    ASSERT_TRUE(is_true(claim, c.found)) << i << ": " << claim.max_error / c.found.surface;
  }
  EXPECT_GT(n_taken, n_mutations / 50) << "some are true as they are";
}

/// The certificate of other meshes: vertices were moved, faces turned, taken away or given other corners.
TEST(SlowMutations, OfMeshesProveNothingFalse) {
  const std::vector<Case> all = cases();
  Random random(18);
  int n_taken = 0;
  for (int i = 0; i < 4000; ++i) {
    const Case& c = all[random.below(all.size())];
    IndexedMesh in = c.in;
    IndexedMesh out = c.out;
    IndexedMesh& changed = random.below(2) == 0 ? in : out;
    Triangle& face = changed.faces[random.below(changed.faces.size())];
    Index& corner = face[random.below(3)];
    switch (random.below(3)) {
      case 0:
        changed.positions[corner] += random.uniform(0, 2) * c.claimed.surface * random.uniform_vector(-1, 1);
        break;
      case 1:
        corner = static_cast<Index>(random.below(changed.positions.size()));
        break;
      default:
        std::swap(face, changed.faces.front());
    }
    const verify::Verification claim = verified(in, out, c.certificate);
    if (!claim.holds) continue;
    ++n_taken;
    ASSERT_TRUE(is_true(claim, found_distances(in, out))) << i;
  }
  EXPECT_GT(n_taken, 100);
  EXPECT_LT(n_taken, 2000);
}

}  // namespace
}  // namespace whittle::test
