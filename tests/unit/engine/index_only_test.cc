#include <gtest/gtest.h>

#include <algorithm>

#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"
#include "whittle/engine/decimate.hh"

namespace whittle::test {
namespace {

void expect_same_surface(const IndexedMesh& mesh, const DecimateTarget& target, DecimateOptions options,
                         const std::string& name) {
  const IndexOnlyDecimation kept = decimate_index_only(mesh, target, options);
  options.quadric.placement = Placement::endpoint;
  const Decimation placed = decimate(mesh, target, options);
  ASSERT_EQ(kept.faces.size(), placed.mesh.faces.size()) << name;
  for (std::size_t f = 0; f < kept.faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(mesh.positions[kept.faces[f][c]], placed.mesh.positions[placed.mesh.faces[f][c]]) << name << ' ' << f;
    }
  }
  EXPECT_EQ(kept.face_origins, placed.face_origins) << name;
  EXPECT_EQ(kept.result.n_contractions, placed.result.n_contractions) << name;
}

TEST(IndexOnly, FacesHaveTheInputsPositionsToTheBit) {
  for (const auto& [name, mesh] : all_meshes()) {
    for (const Cost cost : {Cost::quadric, Cost::memoryless}) {
      DecimateOptions options;
      options.cost = cost;
      expect_same_surface(mesh, DecimateTarget::faces(mesh.faces.size() / 5), options, name);
    }
  }
  DecimateOptions options;
  options.pairs.threshold = 0.3;
  expect_same_surface(moved(boxes(2, 2, 0.2), Vec3(1e4, 0.1, -7)), DecimateTarget::faces(30), options, "boxes");
}

TEST(IndexOnly, VertexMapNamesVerticesThatStandForThemselves) {
  const IndexedMesh mesh = blob(3, 5);
  const IndexOnlyDecimation kept = decimate_index_only(mesh, DecimateTarget::faces(200));
  EXPECT_EQ(kept.result.n_faces, 200U);
  for (const Triangle& face : kept.faces) {
    for (const Index v : face) EXPECT_EQ(kept.vertex_map[v], v);
  }
  for (const Index v : kept.vertex_map) EXPECT_EQ(kept.vertex_map[v], v);
}

TEST(IndexOnly, RefusesCostsWithAPlacementOfTheirOwn) {
  DecimateOptions options;
  options.cost = Cost::midpoint;
  EXPECT_THROW(decimate_index_only(blob(2, 1), DecimateTarget::faces(50), options), std::invalid_argument);
}

}  // namespace
}  // namespace whittle::test
