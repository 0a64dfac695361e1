// The pairs that stand in the way of a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::test {
namespace {

TEST(RefusedPairs, AreThoseLeftWhenARunCanDoNoMore) {
  for (const auto& [name, mesh] : all_meshes()) {
    for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
      SCOPED_TRACE(name);
      DecimateOptions options;
      options.cost = cost;
      options.max_normal_flip_deg = 30;
      const Decimation d = decimate(mesh, DecimateTarget::faces(1), options);
      if (d.result.stop != StopReason::exhausted) continue;
      std::set<std::array<Index, 2>> edges;
      for (const Triangle& f : d.mesh.faces) {
        for (std::size_t k = 0; k < 3; ++k)
          edges.insert({std::min(f[k], f[(k + 1) % 3]), std::max(f[k], f[(k + 1) % 3])});
      }
      RefusalCounts counted;
      std::set<std::array<Index, 2>> named;
      for (const auto& [pair, reason] : d.refused_pairs) {
        ++counted[reason];
        EXPECT_TRUE(named.insert({pair.a, pair.b}).second);
        EXPECT_TRUE(edges.contains({pair.a, pair.b})) << pair.a << ' ' << pair.b;
      }
      EXPECT_EQ(counted[Refusal::link], d.result.refused_at_end[Refusal::link]);
      EXPECT_EQ(counted[Refusal::flip], d.result.refused_at_end[Refusal::flip]);
      EXPECT_EQ(counted[Refusal::link] + counted[Refusal::flip], d.refused_pairs.size());
    }
  }
}

TEST(RefusedPairs, AreNoneWhereARunReachesItsTarget) {
  EXPECT_TRUE(decimate(blob(3, 2), DecimateTarget::faces(400)).refused_pairs.empty());
}

}  // namespace
}  // namespace whittle::test
