// Proofs of the largest distance, compared with distances in rational arithmetic. Coordinates are small integers, and
// points divide the faces by powers of two, so that 128 bits are enough.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/random.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::test {

using namespace metrics;

namespace {

__extension__ using Integer = __int128;

using Vector = std::array<Integer, 3>;
using Face = std::array<Vector, 3>;

/// A rational number of which the denominator is positive.
struct Ratio {
  Integer above;
  Integer below;

  bool operator<(const Ratio& other) const { return above * other.below < other.above * below; }
};

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Ratio square_distance_to_segment(const Vector& a, const Vector& b, const Vector& p) {
  const Vector along = b - a;
  const Integer t = dot(p - a, along);
  const Integer end = dot(along, along);
  if (t <= 0) return {dot(p - a, p - a), 1};
  if (t >= end) return {dot(p - b, p - b), 1};
  const Vector across = cross(along, p - a);
  return {dot(across, across), end};
}

Ratio square_distance_to_face(const Face& face, const Vector& p) {
  const auto& [a, b, c] = face;
  const Vector normal = cross(b - a, c - a);
  const auto is_left = [&](const Vector& from, const Vector& to) {
    return dot(normal, cross(to - from, p - from)) >= 0;
  };
  const Integer square = dot(normal, normal);
  if (square > 0 && is_left(a, b) && is_left(b, c) && is_left(c, a)) {
    const Integer height = dot(normal, p - a);
    return {height * height, square};
  }
  return std::min(
      {square_distance_to_segment(a, b, p), square_distance_to_segment(b, c, p), square_distance_to_segment(c, a, p)});
}

Ratio square_distance(const std::vector<Face>& faces, const Vector& p) {
  Ratio least = square_distance_to_face(faces[0], p);
  for (const Face& face : faces) least = std::min(least, square_distance_to_face(face, p));
  return least;
}

/// Coordinates are multiplied by this, so that faces can be halved eight times.
constexpr int unit = 1 << 8;

/// The farthest of points that halving the longest edges yields, the most promising halves first.
Ratio farthest_square(const std::vector<Face>& from, const std::vector<Face>& to, Random& random) {
  Ratio most{0, 1};
  for (const Face& face : from) {
    for (int i = 0; i < 6; ++i) {
      Face piece = face;
      for (int depth = 0; depth < 8; ++depth) {
        for (const Vector& p : piece) most = std::max(most, square_distance(to, p));
        const std::size_t k = random.below(3);
        const Vector middle = piece[k] + piece[(k + 1) % 3];
        const Vector half{middle[0] / 2, middle[1] / 2, middle[2] / 2};
        Face first = piece;
        Face second = piece;
        first[(k + 1) % 3] = half;
        second[k] = half;
        const bool takes_first = square_distance(to, first[k]) < square_distance(to, second[(k + 1) % 3]);
        piece = takes_first == (i % 2 == 0) ? first : second;
      }
    }
  }
  return most;
}

struct Pair {
  IndexedMesh first;
  IndexedMesh second;
};

IndexedMesh with_noise(IndexedMesh mesh, int most, Random& random) {
  for (Vec3& p : mesh.positions) {
    for (double& x : p) x += static_cast<double>(random.below(2 * static_cast<std::uint64_t>(most) + 1)) - most;
  }
  return mesh;
}

Pair random_pair(Random& random) {
  Pair pair;
  const std::size_t n_faces = 1 + random.below(6);
  for (std::size_t v = 0; v < n_faces + 2; ++v) pair.first.positions.push_back(Vec3::Zero());
  pair.first = with_noise(pair.first, 12, random);
  for (std::size_t f = 0; f < n_faces; ++f) {
    pair.first.faces.push_back({static_cast<Index>(random.below(n_faces + 2)),
                                static_cast<Index>(random.below(n_faces + 2)),
                                static_cast<Index>(random.below(n_faces + 2))});
  }
  pair.second = with_noise(pair.first, 1 + static_cast<int>(random.below(4)), random);
  return pair;
}

std::vector<Face> faces_of(const IndexedMesh& mesh) {
  std::vector<Face> faces;
  for (const Triangle& triangle : mesh.faces) {
    Face face;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        face[i][static_cast<std::size_t>(axis)] = static_cast<Integer>(mesh.positions[triangle[i]][axis]) * unit;
      }
    }
    faces.push_back(face);
  }
  return faces;
}

/// The greatest 2⁻²⁰th, in coordinates of the meshes, whose square is below `square`, of coordinates times `unit`.
double just_below_root(const Ratio& square) {
  constexpr std::int64_t parts = 1 << 20;
  const auto is_below = [&](std::int64_t root) {
    return Ratio{Integer{root} * root * unit * unit, Integer{parts} * parts} < square;
  };
  auto root = static_cast<std::int64_t>(
      std::sqrt(static_cast<double>(square.above) / static_cast<double>(square.below)) / unit * parts + 2);
  while (root > 0 && !is_below(root)) --root;
  return static_cast<double>(root) / parts;
}

TEST(SlowCertify, IsRightInRationalArithmetic) {
  constexpr int n_pairs = 10'000;
  Random random(11);
  int n_close = 0;
  int n_in_vain = 0;
  for (int i = 0; i < n_pairs; ++i) {
    SCOPED_TRACE(i);
    const auto [first, second] = random_pair(random);
    const std::vector<Face> of_first = faces_of(first);
    const std::vector<Face> of_second = faces_of(second);
    const Ratio farthest =
        std::max(farthest_square(of_first, of_second, random), farthest_square(of_second, of_first, random));
    const double too_small = just_below_root(farthest);
    if (too_small > 0) {
      EXPECT_NE(certify(first, second, too_small, {.threads = 1}).verdict, Verdict::proven);
    }
    const LargestDistances largest = largest_distances(first, second, 1e-4, {.threads = 1});
    const double at_least = std::max(largest.forward.at_least, largest.backward.at_least);
    EXPECT_GE(std::max(largest.forward.at_most, largest.backward.at_most), too_small);
    if (at_least == 0) continue;
    n_close += static_cast<int>(too_small > 0.999 * at_least);
    n_in_vain += static_cast<int>(certify(first, second, 1.01 * at_least, {.threads = 1}).verdict != Verdict::proven);
  }
  EXPECT_GT(n_close, n_pairs / 2) << "most pairs are tried close to their largest distance";
  EXPECT_EQ(n_in_vain, 0);
}

}  // namespace
}  // namespace whittle::test
