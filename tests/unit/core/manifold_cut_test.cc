#include "whittle/core/manifold_cut.hh"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/topology.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

ManifoldCut cut(const IndexedMesh& mesh) { return cut_into_manifold(mesh.positions.size(), mesh.faces); }

/// The faces of the cut mesh with the vertices they had before the cut.
std::vector<Triangle> rejoined(const ManifoldCut& cut, std::size_t n_vertices) {
  std::vector<Triangle> faces = cut.faces;
  for (Triangle& face : faces) {
    for (Index& v : face) {
      if (v >= n_vertices) v = cut.originals[v - n_vertices];
    }
  }
  return faces;
}

using Corner = std::pair<Index, Index>;  // a face and one of its vertices

/// The fans at every vertex by their definition: for each corner, the lowest corner of its fan. Sets grow until nothing
/// changes.
std::map<Corner, Corner> fans_by_definition(const IndexedMesh& mesh) {
  std::map<std::pair<Index, Index>, std::vector<Index>> faces_from;  // by directed edge
  std::map<Corner, Corner> lowest;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    if (!has_three_corners(mesh.faces[f])) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      faces_from[{mesh.faces[f][i], mesh.faces[f][(i + 1) % 3]}].push_back(f);
      lowest[{f, mesh.faces[f][i]}] = {f, mesh.faces[f][i]};
    }
  }
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& [edge, there] : faces_from) {
      const auto back = faces_from.find({edge.second, edge.first});
      if (there.size() != 1 || back == faces_from.end() || back->second.size() != 1) continue;
      for (const Index v : {edge.first, edge.second}) {
        Corner& one = lowest[{there[0], v}];
        Corner& other = lowest[{back->second[0], v}];
        has_changed = has_changed || one != other;
        one = other = std::min(one, other);
      }
    }
  }
  return lowest;
}

void expect_cut_by_definition(const IndexedMesh& mesh, const std::string& name) {
  const ManifoldCut result = cut(mesh);
  ASSERT_EQ(rejoined(result, mesh.positions.size()), mesh.faces) << name << ": a face lost, turned or moved";

  IndexedMesh after;
  after.positions.resize(mesh.positions.size() + result.originals.size());
  after.faces = result.faces;
  const Topology t = topology(after);
  EXPECT_TRUE(t.manifold()) << name << ": " << t;
  EXPECT_EQ(t.misoriented_edges, 0) << name << ": " << t;

  std::map<Index, Corner> fan_of;  // by vertex of the cut
  std::set<Corner> fans;
  for (const auto& [corner, fan] : fans_by_definition(mesh)) {
    const Triangle& face = mesh.faces[corner.first];
    const auto place = static_cast<std::size_t>(std::find(face.begin(), face.end(), corner.second) - face.begin());
    const Index copy = result.faces[corner.first][place];
    const auto [known, is_new] = fan_of.try_emplace(copy, fan);
    EXPECT_EQ(known->second, fan) << name << ": two fans in vertex " << copy;
    fans.insert(fan);
  }
  EXPECT_EQ(fan_of.size(), fans.size()) << name << ": a fan with two vertices";
}

/// Adds defects to a mesh: random faces are doubled, reversed, pinched together or removed.
IndexedMesh spoilt(const IndexedMesh& mesh, std::uint64_t seed) {
  Random random(seed);
  IndexedMesh result;
  result.positions = mesh.positions;
  for (const Triangle& face : mesh.faces) {
    const std::uint64_t what = random.below(20);
    if (what == 0) continue;
    result.faces.push_back(face);
    Triangle& last = result.faces.back();
    if (what == 1) std::swap(last[1], last[2]);
    if (what == 2) last[1] = last[2];
    if (what == 3) last[random.below(3)] = static_cast<Index>(random.below(mesh.positions.size()));
    if (what == 4) result.faces.push_back({face[1], face[2], face[0]});
    if (what == 5) result.faces.push_back({face[2], face[1], face[0]});
  }
  return result;
}

TEST(ManifoldCut, LeavesWhatIsManifoldAlone) {
  for (const auto& [name, mesh] : all_meshes()) {
    const Topology t = topology(mesh);
    if (!t.manifold() || t.misoriented_edges > 0) continue;
    const ManifoldCut result = cut(mesh);
    EXPECT_EQ(result.faces, mesh.faces) << name;
    EXPECT_THAT(result.originals, IsEmpty()) << name;
  }
  EXPECT_THAT(cut(IndexedMesh{}).faces, IsEmpty());
}

TEST(ManifoldCut, MakesOneVertexOfEachFan) {
  for (const auto& [name, mesh] : all_meshes()) expect_cut_by_definition(mesh, name);
  expect_cut_by_definition(moebius(12), "moebius(12)");
  expect_cut_by_definition(pillow(), "pillow()");
  expect_cut_by_definition(two_cubes_on_an_edge(3), "two_cubes_on_an_edge(3)");
  expect_cut_by_definition(joined(sphere(1), IndexedMesh{}), "sphere(1)");
}

TEST(ManifoldCut, MakesOneVertexOfEachFanOfSpoiltMeshes) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string context = "seed " + std::to_string(seed);
    expect_cut_by_definition(spoilt(noisy_grid(6, 5, 0.2, seed), seed), context + ", grid");
    expect_cut_by_definition(spoilt(octahedron(), seed), context + ", octahedron");
    expect_cut_by_definition(spoilt(two_cubes_on_an_edge(2), seed), context + ", cubes");
  }
}

TEST(ManifoldCut, PartsTwoConesAtTheirTip) {
  const ManifoldCut result = cut(bow_tie());
  EXPECT_THAT(result.originals, ElementsAre(0U));
  const std::vector<Triangle> whole = bow_tie().faces;
  for (Index f = 0; f < 4; ++f) EXPECT_EQ(result.faces[f], whole[f]) << "the first keeps its vertices";
}

TEST(ManifoldCut, PartsAllFacesAtAnEdgeWithThree) {
  const ManifoldCut result = cut(three_faces_on_an_edge());
  EXPECT_THAT(result.originals, ElementsAre(0U, 1U, 0U, 1U));
  EXPECT_THAT(result.faces, ElementsAre(Triangle{0, 1, 2}, Triangle{5, 6, 3}, Triangle{7, 8, 4}));
}

TEST(ManifoldCut, PartsFacesThatRunAlongTheirEdgeTheSameWay) {
  const std::vector<Triangle> faces{{0, 1, 2}, {0, 1, 3}};
  const ManifoldCut result = cut_into_manifold(4, faces);
  EXPECT_THAT(result.originals, ElementsAre(0U, 1U));
  EXPECT_THAT(result.faces, ElementsAre(Triangle{0, 1, 2}, Triangle{4, 5, 3}));
}

TEST(ManifoldCut, LeavesFacesBackToBackClosed) {
  EXPECT_THAT(cut(pillow()).originals, IsEmpty());
  const std::vector<Triangle> doubled{{0, 1, 2}, {1, 2, 0}};
  EXPECT_THAT(cut_into_manifold(3, doubled).faces, ElementsAre(Triangle{0, 1, 2}, Triangle{3, 4, 5}));
}

TEST(ManifoldCut, GivesEachBodyItsOwnEdge) {
  const ManifoldCut result = cut(two_cubes_on_an_edge(1));
  IndexedMesh after;
  after.positions.resize(16);
  after.faces = result.faces;
  EXPECT_EQ(result.originals.size(), 2U);
  EXPECT_TRUE(topology(after).closed()) << "the faces of a cube were parted, that are joined around both ends";
  EXPECT_EQ(topology(after).components, 2);
}

TEST(ManifoldCut, DoesNotDependOnTheNumbersOfTheVertices) {
  for (const auto& [name, mesh] : nonmanifold_meshes()) {
    Permuted other = permuted(mesh, 5);
    EXPECT_EQ(cut(other.mesh).originals.size(), cut(mesh).originals.size()) << name;
  }
}

TEST(OppositeSides, ArePairsThatRunBothWaysAlongAnEdge) {
  const std::vector<Triangle> faces{{0, 1, 2}, {1, 0, 3}, {3, 3, 2}, {2, 1, 4}, {1, 2, 5}, {5, 2, 0}};
  const std::vector<Index> opposite = opposite_sides(6, faces);
  const Index none = invalid_index;
  EXPECT_THAT(opposite, ElementsAre(3, none, none, 0, none, none, none, none, none,  // edge 1 2 has three faces
                                    none, none, none, none, 15, none, 13, none, none))
      << "2 0 is run along twice the same way";
}

}  // namespace
}  // namespace whittle::test
