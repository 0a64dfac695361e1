// Faces that are folded over on a texture are found, and laid flat again.
#include "attributes/texture_folds.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

using polishing::AttributeSamples;

constexpr int n_squares = 12;

/// A grid whose texture coordinates are its positions, mirrored right of the middle: the second half lies on the first.
struct MirroredGrid {
  IndexedMesh mesh = grid(n_squares, n_squares);
  std::vector<double> texcoords;
  std::vector<std::int8_t> turns;

  MirroredGrid() {
    for (const Vec3& p : mesh.positions) {
      texcoords.push_back(std::min(p.x(), n_squares - p.x()));
      texcoords.push_back(p.y());
    }
    for (const Triangle& face : mesh.faces) {
      const double middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]).x() / 3;
      turns.push_back(middle < n_squares / 2.0 ? 1 : -1);
    }
  }

  double area(std::size_t f) const {
    const auto& [a, b, c] = mesh.faces[f];
    const double* const t = texcoords.data();
    return (t[2 * b] - t[2 * a]) * (t[2 * c + 1] - t[2 * a + 1]) -
           (t[2 * b + 1] - t[2 * a + 1]) * (t[2 * c] - t[2 * a]);
  }
  std::size_t n_folded() const {
    std::size_t n = 0;
    for (std::size_t f = 0; f < turns.size(); ++f) n += static_cast<std::size_t>(turns[f] * area(f) < -1e-9);
    return n;
  }
};

TEST(TextureFolds, AreNoneWhereTheOriginalIsMirrored) {
  MirroredGrid grid;
  std::vector<AttributeSamples::Sample> samples;
  for (Index f = 0; f < grid.mesh.faces.size(); ++f) {
    AttributeSamples::Sample sample;
    sample.closest.face = f;
    sample.weight = 1;
    samples.push_back(sample);
  }
  EXPECT_EQ(turns_on_image({grid.mesh.faces, grid.texcoords, 2}, samples, grid.mesh.faces.size()), grid.turns);
  const std::vector<double> before = grid.texcoords;
  EXPECT_EQ(polishing::unfold(grid.mesh.faces, grid.turns, grid.texcoords, 2), 0);
  EXPECT_EQ(grid.texcoords, before);
}

TEST(TextureFolds, HaveNoSideWhereTheOriginalDisagrees) {
  const MirroredGrid grid;
  std::vector<AttributeSamples::Sample> samples(grid.mesh.faces.size());
  for (AttributeSamples::Sample& sample : samples) {
    sample.closest.face = 0;  // one face has all of them, half of which are mirrored
    sample.weight = 1;
  }
  samples.back().closest.face = 1;
  EXPECT_EQ(turns_on_image({grid.mesh.faces, grid.texcoords, 2}, samples, 3), (std::vector<std::int8_t>{0, -1, 0}));
}

TEST(TextureFolds, GoWhereOneVertexIsOff) {
  MirroredGrid grid;
  const Index v = 4 * (n_squares + 1) + 3;
  std::vector<double> expected = grid.texcoords;
  grid.texcoords[std::size_t{2} * v] += 2.5;
  EXPECT_GT(grid.n_folded(), 0);
  EXPECT_EQ(polishing::unfold(grid.mesh.faces, grid.turns, grid.texcoords, 2), 0);
  EXPECT_EQ(grid.n_folded(), 0);
}

/// Random errors of up to an edge each way. No single vertex could unfold many of these faces.
TEST(TextureFolds, GoFromRandomTextures) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> error(-1, 1);
  for (int round = 0; round < 50; ++round) {
    MirroredGrid grid;
    for (double& x : grid.texcoords) x += error(random);
    const std::size_t n_before = grid.n_folded();
    const std::size_t n_left = polishing::unfold(grid.mesh.faces, grid.turns, grid.texcoords, 2);
    EXPECT_GT(n_before, 10);
    EXPECT_EQ(n_left, 0);
    EXPECT_EQ(grid.n_folded(), 0);
  }
}

}  // namespace
}  // namespace whittle::test
