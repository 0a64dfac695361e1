// Proofs that are kept while a surface changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <whittle/core/geometry/proof/border_edges.hh>
#include <whittle/metrics/certify.hh>
#include <whittle/metrics/detail/surface_proof.hh>

#include "support/brute_distance.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle::test {
namespace {

using metrics::SurfaceProof;

std::vector<SurfaceProof::Face> numbered(const IndexedMesh& mesh) {
  std::vector<SurfaceProof::Face> faces;
  for (Index f = 0; f < mesh.faces.size(); ++f) faces.push_back({f, mesh.faces[f]});
  return faces;
}

/// A surface whose vertices move one by one, and its proof.
class MovingSurface {
 public:
  MovingSurface(const IndexedMesh& original, double limit) : proof_(original, limit), surface_(original) {
    proof_.start(surface_.positions, numbered(surface_));
  }

  /// Moves a vertex, if that is allowed or `even_if_not`. \return whether it was allowed
  bool move(Index v, const Vec3& position, bool even_if_not) {
    SurfaceProof::Change change;
    change.moved = v;
    change.position = position;
    for (const SurfaceProof::Face& face : numbered(surface_)) {
      const bool is_at_v = std::find(face.vertices.begin(), face.vertices.end(), v) != face.vertices.end();
      if (is_at_v) change.removed.push_back(face.number);
      (is_at_v ? change.added : around_).push_back(face);
    }
    for (const SurfaceProof::Face& face : around_) change.around.push_back(face.number);
    around_.clear();
    const bool is_allowed = proof_.allows(change);
    if (is_allowed || even_if_not) {
      proof_.make(change);
      surface_.positions[v] = position;
    }
    return is_allowed;
  }
  SurfaceProof& proof() { return proof_; }
  const IndexedMesh& surface() const { return surface_; }

 private:
  SurfaceProof proof_;
  IndexedMesh surface_;
  std::vector<SurfaceProof::Face> around_;
};

Vec3 random_step(Random& random, double size) { return random.uniform_vector(-size, size); }

TEST(SurfaceProof, WhatItAllowsIsRight) {
  int n_allowed = 0;
  for (const NamedMesh& shape : all_meshes()) {
    const double limit = 0.05 * diagonal_of(shape.mesh.positions);
    MovingSurface moving(shape.mesh, limit);
    EXPECT_TRUE(moving.proof().is_proven()) << shape.name;
    Random random(7);
    for (int i = 0; i < 60; ++i) {
      const auto v = static_cast<Index>(random.below(shape.mesh.positions.size()));
      const Vec3 position = moving.surface().positions[v] + random_step(random, 1.5 * limit);
      if (!moving.move(v, position, false)) continue;
      ++n_allowed;
      EXPECT_TRUE(moving.proof().is_proven()) << shape.name;
      ASSERT_EQ(metrics::certify(shape.mesh, moving.surface(), (1 + 1e-12) * limit).verdict, Verdict::proven)
          << shape.name << ", move " << i;
    }
  }
  EXPECT_GT(n_allowed, 500);
}

TEST(SurfaceProof, KnowsWhatItCouldNotProve) {
  for (const NamedMesh& shape : all_meshes()) {
    const double limit = 0.05 * diagonal_of(shape.mesh.positions);
    MovingSurface moving(shape.mesh, limit);
    Random random(8);
    int n_proven = 0;
    for (int i = 0; i < 30; ++i) {
      const auto v = static_cast<Index>(random.below(shape.mesh.positions.size()));
      const Vec3 position = shape.mesh.positions[v] + random_step(random, 2 * limit);
      moving.move(v, position, true);
      n_proven += static_cast<int>(moving.proof().is_proven());
      if (!moving.proof().is_proven()) continue;
      ASSERT_EQ(metrics::certify(shape.mesh, moving.surface(), (1 + 1e-12) * limit).verdict, Verdict::proven)
          << shape.name << ", move " << i;
    }
    EXPECT_LT(n_proven, 30) << shape.name;
    for (int turn = 0; turn < 2; ++turn) {  // in the second turn, what may rest on faces that were to move back
      for (Index v = 0; v < shape.mesh.positions.size(); ++v) moving.move(v, shape.mesh.positions[v], true);
    }
    EXPECT_TRUE(moving.proof().is_proven()) << shape.name << ", with all vertices back where they were";
  }
}

TEST(SurfaceProof, AllowsWhatIsFarWithinTheLimit) {
  for (const NamedMesh& shape : all_meshes()) {
    const double limit = 0.05 * diagonal_of(shape.mesh.positions);
    MovingSurface moving(shape.mesh, limit);
    Random random(9);
    for (Index v = 0; v < shape.mesh.positions.size(); ++v) {
      const Vec3 position = shape.mesh.positions[v] + random_step(random, 0.5 * limit);
      EXPECT_TRUE(moving.move(v, position, false)) << shape.name << ", vertex " << v;
    }
  }
}

TEST(SurfaceProof, StartsWithAnySurface) {
  for (const NamedMesh& shape : all_meshes()) {
    const double diagonal = diagonal_of(shape.mesh.positions);
    IndexedMesh surface = shape.mesh;
    Random random(10);
    for (Vec3& p : surface.positions) p += random_step(random, 0.02 * diagonal);
    std::reverse(surface.faces.begin(), surface.faces.end());
    for (const double limit : {0.04 * diagonal, 0.002 * diagonal}) {
      SurfaceProof proof(shape.mesh, limit);
      proof.start(surface.positions, numbered(surface));
      const Verdict verdict = metrics::certify(shape.mesh, surface, limit).verdict;
      EXPECT_EQ(proof.is_proven(), verdict == Verdict::proven) << shape.name << ", " << limit;
    }
  }
}

TEST(SurfaceProof, ProvesBordersAsSegments) {
  for (const NamedMesh& shape : open_meshes()) {
    const double limit = 0.05 * diagonal_of(shape.mesh.positions);
    const IndexedMesh border = border_edges_of(shape.mesh).mesh;
    MovingSurface moving(border, limit);
    EXPECT_TRUE(moving.proof().is_proven()) << shape.name;
    Random random(11);
    for (int i = 0; i < 60; ++i) {
      const Index v = border.faces[random.below(border.faces.size())][0];
      moving.move(v, moving.surface().positions[v] + random_step(random, 1.5 * limit), false);
    }
    IndexedMesh surface = shape.mesh;
    surface.positions = moving.surface().positions;
    EXPECT_EQ(metrics::certify_borders(shape.mesh, surface, (1 + 1e-12) * limit).verdict, Verdict::proven)
        << shape.name;
  }
}

}  // namespace
}  // namespace whittle::test
