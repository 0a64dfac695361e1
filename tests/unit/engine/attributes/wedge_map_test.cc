// What becomes of wedges, by following the contractions one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "support/shapes/shapes.hh"
#include "support/transforms.hh"
#include "whittle/core/wedges.hh"
#include "whittle/engine/attributes.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::test {
namespace {

/// Wedges as sets. A contraction of (a, b) joins the two wedges that each face with both corners has there.
class FollowedWedges {
 public:
  explicit FollowedWedges(const IndexedMesh& mesh) : faces_(mesh.faces), corners_(3 * mesh.faces.size()) {
    for (std::size_t c = 0; c < corners_.size(); ++c) corners_[c] = mesh.wedge(c / 3, c % 3);
    is_there_.assign(faces_.size(), true);
  }

  void contract(Index survivor, Index removed) {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (!is_there_[f]) continue;
      std::vector<std::size_t> ends;
      for (std::size_t k = 0; k < 3; ++k) {
        if (faces_[f][k] == survivor || faces_[f][k] == removed) ends.push_back(3 * f + k);
      }
      if (ends.size() == 2) {
        is_there_[f] = false;
        rename(corners_[ends[0]], corners_[ends[1]]);
      }
    }
    for (Triangle& face : faces_) {
      for (Index& v : face) v = v == removed ? survivor : v;
    }
  }

  Index wedge(std::size_t face, std::size_t corner) const { return corners_[3 * face + corner]; }
  bool is_there(std::size_t face) const { return is_there_[face]; }

 private:
  void rename(Index from, Index to) {
    for (Index& w : corners_) w = w == from ? to : w;
  }

  std::vector<Triangle> faces_;
  std::vector<Index> corners_;
  std::vector<bool> is_there_;
};

TEST(WedgeMap, IsWhatFollowingEachContractionGives) {
  for (IndexedMesh mesh : {charted_cube(6), textured_torus(24, 16)}) {
    join_equal_wedges(mesh);
    for (const Cost cost : {Cost::quadric, Cost::memoryless, Cost::lindstrom_turk}) {
      for (const double share : {0.5, 0.2, 0.06}) {
        const auto n = static_cast<std::uint64_t>(share * static_cast<double>(mesh.faces.size()));
        FollowedWedges followed(mesh);
        DecimateOptions options;
        options.cost = cost;
        options.listener = [&](const Contraction& c) { followed.contract(c.survivor, c.removed); };
        const Decimation d = decimate(mesh, DecimateTarget::faces(n), options);
        std::map<Index, Index> numbers;
        std::set<Index> used;
        for (std::size_t f = 0; f < d.mesh.faces.size(); ++f) {
          ASSERT_TRUE(followed.is_there(d.face_origins[f]));
          for (std::size_t k = 0; k < 3; ++k) {
            const Index wedge = d.mesh.wedge(f, k);
            const auto [found, is_new] = numbers.try_emplace(followed.wedge(d.face_origins[f], k), wedge);
            EXPECT_EQ(found->second, wedge);
            const bool is_other = !is_new || used.insert(wedge).second;
            EXPECT_TRUE(is_other) << "two wedges became one";
          }
        }
        EXPECT_EQ(used.size(), n_wedges(d.mesh));
      }
    }
  }
}

TEST(WedgeMap, KeepsEachWedgeInTheRangeOfThoseAround) {
  const IndexedMesh mesh = textured_torus(24, 16);
  const Decimation d = decimate(mesh, DecimateTarget::faces(100));
  const std::vector<Index> map = wedge_map(mesh, d.vertex_map, d.face_origins);
  std::vector<double> low(n_wedges(d.mesh), std::numeric_limits<double>::infinity());
  std::vector<double> high(low.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 9; ++k) {
      const Index become = map[mesh.wedge(f, k / 3)];
      if (become == invalid_index) continue;
      const double u = mesh.attributes[0].value(mesh.wedge(f, k % 3))[0];
      low[become] = std::min(low[become], u);
      high[become] = std::max(high[become], u);
    }
  }
  for (Index w = 0; w < low.size(); ++w) {
    const double u = d.mesh.attributes[0].value(w)[0];
    EXPECT_TRUE(u >= low[w] && u <= high[w]) << u << " beside " << low[w] << " to " << high[w];
  }
}

TEST(WedgeMap, IsTheVertexMapWithoutSeams) {
  const IndexedMesh mesh = blob(2, 3);
  const Decimation d = decimate(mesh, DecimateTarget::faces(50));
  EXPECT_EQ(wedge_map(mesh, d.vertex_map, d.face_origins), d.vertex_map);
}

}  // namespace
}  // namespace whittle::test
