#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <whittle/core/frame.hh>
#include <whittle/metrics/certify.hh>
#include <whittle/openmesh/conversions.hh>

#include "support/brute_distance.hh"
#include "whittle/core/geometry/box.hh"

namespace whittle::test {

/// A length by its share of the diagonal of a mesh.
inline double share_of_diagonal(const IndexedMesh& mesh, double share) { return share * diagonal_of(mesh.positions); }

/// The largest distance of some points of each face from the other mesh, found face by face.
inline double sampled_distance(const IndexedMesh& from, const IndexedMesh& to) {
  double largest = 0;
  for (Index f = 0; f < from.faces.size(); ++f) {
    const auto& [a, b, c] = corners_of(from, f);
    for (const Vec3& weights : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(.5, .5, 0), Vec3(0, .5, .5),
                                Vec3(.5, 0, .5), Vec3(1. / 3, 1. / 3, 1. / 3)}) {
      const Vec3 point = weights[0] * a + weights[1] * b + weights[2] * c;
      largest = std::max(largest, distance_to_all(to, point));
    }
  }
  return largest;
}

/// Expects all points of both surfaces to be proven to be within a distance of the other one, and the same of borders.
/// Frames of proofs differ: by 1e-12 in all.
inline void expect_certified(const IndexedMesh& input, const IndexedMesh& mesh, double distance, double border_distance,
                             const std::string& context) {
  constexpr double room = 1 + 1e-12;
  EXPECT_EQ(metrics::certify(input, mesh, room * distance).verdict, Verdict::proven) << context;
  EXPECT_EQ(metrics::certify_borders(input, mesh, room * border_distance).verdict, Verdict::proven) << context;
}

/// The same, and by an independent search.
inline void expect_within(const IndexedMesh& input, const IndexedMesh& mesh, double distance,
                          const std::string& context) {
  expect_certified(input, mesh, distance, distance, context);
  constexpr double room = 1 + 1e-9;
  EXPECT_LE(sampled_distance(input, mesh), room * distance) << context;
  EXPECT_LE(sampled_distance(mesh, input), room * distance) << context;
}

}  // namespace whittle::test
