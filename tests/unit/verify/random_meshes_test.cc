// Certificates of random meshes, found by trying all steps. What is proven is compared with distances of many points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "certificate.hh"
#include "support/brute_distance.hh"
#include "support/random.hh"

namespace whittle::test {
namespace {

using verify::Verification;

/// The largest distance of many points of one surface from the other one: a lower bound.
double sampled_distance(const IndexedMesh& from, const IndexedMesh& to, int n) {
  double most = 0;
  for (Index f = 0; f < from.faces.size(); ++f) {
    const auto& [a, b, c] = corners_of(from, f);
    for (int i = 0; i <= n; ++i) {
      for (int k = 0; i + k <= n; ++k) {
        const Vec3 p = a + static_cast<double>(i) / n * (b - a) + static_cast<double>(k) / n * (c - a);
        most = std::max(most, distance_to_all(to, p));
      }
    }
  }
  return most;
}

double sampled_distance(const IndexedMesh& a, const IndexedMesh& b) {
  constexpr int n = 12;
  return std::max(sampled_distance(a, b, n), sampled_distance(b, a, n));
}

/// Searches for proofs by asking the verifier about each step.
class Prover {
 public:
  /// \param target that triangles are to be near to
  Prover(const IndexedMesh& target, double max_error) : target_(target), max_error_(max_error) {}

  /// Adds the proof of a triangle. \return whether there is one
  bool prove(const Corners& c, int depth, Steps& steps) {
    for (Index f = 0; f < target_.faces.size(); ++f) {
      if (is_proven(c, Steps().face(f))) {
        steps.face(f);
        return true;
      }
    }
    for (Index f = 0; f < target_.faces.size(); ++f) {
      if (is_proven(c, Steps().patch(f))) {
        steps.patch(f);
        ++n_patches_;
        return true;
      }
    }
    if (depth == 0) return false;
    unsigned longest = 0;
    for (unsigned i = 1; i < 3; ++i) {
      if ((c[(i + 1) % 3] - c[i]).norm() > (c[(longest + 1) % 3] - c[longest]).norm()) longest = i;
    }
    const auto& [from, to, opposite] = Corners{c[longest], c[(longest + 1) % 3], c[(longest + 2) % 3]};
    const Vec3 middle = 0.5 * (from + to);
    steps.halve(longest);
    return prove({from, middle, to == opposite ? middle : opposite}, depth - 1, steps) &&
           prove({middle, to, opposite}, depth - 1, steps);
  }
  std::size_t n_patches() const { return n_patches_; }

 private:
  /// As one face of IN. What is wrong with OUT's faces is said only after that.
  bool is_proven(const Corners& c, const Steps& steps) const {
    IndexedMesh in;
    in.positions.assign(c.begin(), c.end());
    in.faces = {{0, 1, 2}};
    const Certificate certificate = Certificate{.max_error = max_error_}.prove(0, steps).prove(1, Steps());
    return verified(in, target_, certificate).why_not.starts_with("OUT");
  }

  const IndexedMesh& target_;
  double max_error_;
  std::size_t n_patches_ = 0;
};

struct Proof {
  Certificate certificate;
  std::size_t n_patches = 0;
};

std::optional<Proof> find_proof(const IndexedMesh& in, const IndexedMesh& out, double max_error) {
  constexpr int most_depth = 5;
  Proof proof{{.max_error = max_error}};
  for (const std::size_t section : {0U, 1U}) {
    const IndexedMesh& from = section == 0 ? in : out;
    Prover prover(section == 0 ? out : in, max_error);
    Steps steps;
    for (Index f = 0; f < from.faces.size(); ++f) {
      if (!prover.prove(corners_of(from, f), most_depth, steps)) return std::nullopt;
    }
    proof.certificate.prove(section, steps);
    proof.n_patches += prover.n_patches();
  }
  return proof;
}

/// A closed surface that is likely to cross itself, and some faces less or more.
IndexedMesh random_octahedra(std::size_t n, Random& random) {
  IndexedMesh mesh;
  for (Index first = 0; first < 6 * n; first += 6) {
    for (int i = 0; i < 6; ++i) mesh.positions.push_back(random.uniform_vector(-1, 1));
    for (Index i = 0; i < 4; ++i) {
      mesh.faces.push_back({first, first + 2 + i, first + 2 + (i + 1) % 4});
      mesh.faces.push_back({first + 1, first + 2 + (i + 1) % 4, first + 2 + i});
    }
  }
  if (random.below(2) == 0) mesh.faces.erase(mesh.faces.begin() + static_cast<std::ptrdiff_t>(random.below(8)));
  if (random.below(3) == 0) mesh.faces.push_back(mesh.faces[random.below(mesh.faces.size())]);
  return mesh;
}

/// Each face cut into four.
IndexedMesh cut(const IndexedMesh& mesh) {
  IndexedMesh result;
  result.positions = mesh.positions;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [found, is_new] = middles.emplace(std::minmax(a, b), static_cast<Index>(result.positions.size()));
    if (is_new) result.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.faces) {
    const Triangle inner{middle(a, b), middle(b, c), middle(c, a)};
    result.faces.insert(result.faces.end(),
                        {{a, inner[0], inner[2]}, {inner[0], b, inner[1]}, {inner[2], inner[1], c}, inner});
  }
  return result;
}

/// A surface over a square of n × n cells.
IndexedMesh random_terrain(Index n, double height, Random& random) {
  IndexedMesh mesh;
  for (Index y = 0; y <= n; ++y) {
    for (Index x = 0; x <= n; ++x) {
      mesh.positions.emplace_back(static_cast<double>(x) / n, static_cast<double>(y) / n, height * random.uniform());
    }
  }
  for (Index y = 0; y < n; ++y) {
    for (Index x = 0; x < n; ++x) {
      const Index v = y * (n + 1) + x;
      mesh.faces.push_back({v, v + 1, v + n + 2});
      mesh.faces.push_back({v, v + n + 2, v + n + 1});
    }
  }
  return mesh;
}

/// Changes a byte of a proof, the limit, a vertex or a corner.
std::string mutated(IndexedMesh& in, IndexedMesh& out, Certificate certificate, Random& random) {
  IndexedMesh& mesh = random.below(2) == 0 ? in : out;
  const std::uint64_t what = random.below(5);
  if (what == 0) certificate.max_error *= random.uniform(0.8, 1);
  if (what == 1) mesh.positions[random.below(mesh.positions.size())] += 0.05 * random.uniform_vector(-1, 1);
  if (what == 2)
    mesh.faces[random.below(mesh.faces.size())][random.below(3)] =
        static_cast<Index>(random.below(mesh.positions.size()));
  if (what == 3) {
    std::string& steps = certificate.sections[random.below(2)][0];
    steps[random.below(steps.size())] = static_cast<char>(random.below(32));
  }
  if (what == 4) mesh.faces[random.below(mesh.faces.size())] = mesh.faces[random.below(mesh.faces.size())];
  return certificate.bytes(in, out);
}

/// \return how many patches its proof has, or nothing if none was found
std::optional<std::size_t> expect_sound(const IndexedMesh& in, const IndexedMesh& out, double share, int n_mutations,
                                        Random& random) {
  const double distance = sampled_distance(in, out);
  const double max_error = share * distance;
  const std::optional<Proof> proof = find_proof(in, out, max_error);
  if (!proof) return std::nullopt;
  const Verification result = verified(in, out, proof->certificate);
  EXPECT_TRUE(result.holds) << result.why_not;
  EXPECT_GE(max_error, distance * (1 - 1e-12));
  for (int i = 0; i < n_mutations; ++i) {
    IndexedMesh other_in = in;
    IndexedMesh other_out = out;
    const std::string bytes = mutated(other_in, other_out, proof->certificate, random);
    const Verification mutant = verified(other_in, other_out, bytes);
    if (!mutant.holds) continue;
    EXPECT_GE(mutant.max_error, sampled_distance(other_in, other_out) * (1 - 1e-12));
  }
  return proof->n_patches;
}

/// How many proofs were found, and how many patches they have.
struct Found {
  std::size_t n_proofs = 0;
  std::size_t n_patches = 0;

  void count(const std::optional<std::size_t>& patches) {
    n_proofs += patches ? 1 : 0;
    n_patches += patches.value_or(0);
  }
};

TEST(VerifyRandom, ProvesNothingFalseOfAnyFaces) {
  Random random(1);
  Found found;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const IndexedMesh in = random_faces(1 + random.below(6), random);
    IndexedMesh out = in;
    if (i % 3 == 0) out = random_faces(1 + random.below(6), random);
    for (Vec3& p : out.positions) p += 0.1 * random.uniform_vector(-1, 1);
    found.count(expect_sound(in, out, random.uniform(0.9, 1.4), 20, random));
  }
  EXPECT_GT(found.n_proofs, 60U);
}

TEST(SlowVerifyRandom, ProvesNothingFalseOfClosedSurfaces) {
  Random random(3);
  Found found;
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const IndexedMesh in = random_octahedra(1 + random.below(2), random);
    IndexedMesh out = i % 4 == 0 ? random_octahedra(1, random) : cut(in);
    for (Vec3& p : out.positions) p += random.uniform(0, 0.3) * random.uniform_vector(-1, 1);
    found.count(expect_sound(in, out, random.uniform(0.9, 1.3), 40, random));
  }
  EXPECT_GT(found.n_proofs, 10U);
  EXPECT_GT(found.n_patches, 20U);
}

TEST(VerifyRandom, ProvesNothingFalseOfTerrains) {
  Random random(2);
  Found found;
  for (int i = 0; i < 40; ++i) {
    SCOPED_TRACE(i);
    const IndexedMesh in = random_terrain(1 + static_cast<Index>(random.below(3)), 0.1, random);
    const IndexedMesh out = random_terrain(1 + static_cast<Index>(random.below(3)), 0.1, random);
    found.count(expect_sound(in, out, random.uniform(0.9, 1.5), 200, random));
  }
  EXPECT_GT(found.n_proofs, 10U);
  EXPECT_GT(found.n_patches, 50U);
}

}  // namespace
}  // namespace whittle::test
