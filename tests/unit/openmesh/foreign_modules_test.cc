// OpenMesh's own modules in PairDecimaterT.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModIndependentSetsT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalDeviationT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/ModRoundnessT.hh>
#include <functional>
#include <memory>
#include <tuple>
#include <whittle/openmesh/mod_garland_heckbert.hh>

#include "common/link_condition.hh"
#include "common/meshes.hh"
#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

using namespace OpenMesh::Decimater;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using Mesh = DoubleMesh;

/// Adds and sets up modules in any decimater. Keeps their handles, because the decimater writes to them.
class Modules {
 public:
  template <template <class> class ModuleT>
  static Modules with(std::function<void(ModuleT<Mesh>&)> set_up = nullptr) {
    return Modules().and_with<ModuleT>(std::move(set_up));
  }
  template <template <class> class ModuleT>
  Modules and_with(std::function<void(ModuleT<Mesh>&)> set_up = nullptr) const {
    Modules result = *this;
    result.to_pair_.push_back(adder<PairDecimaterT<Mesh>, ModuleT>(set_up));
    result.to_base_.push_back(adder<BaseDecimaterT<Mesh>, ModuleT>(set_up));
    return result;
  }
  void add_to(PairDecimaterT<Mesh>& decimater) const {
    for (const auto& add : to_pair_) add(decimater);
  }
  void add_to(BaseDecimaterT<Mesh>& decimater) const {
    for (const auto& add : to_base_) add(decimater);
  }

 private:
  template <class DecimaterT, template <class> class ModuleT>
  static std::function<void(DecimaterT&)> adder(const std::function<void(ModuleT<Mesh>&)>& set_up) {
    return [set_up](DecimaterT& decimater) {
      ModHandleT<ModuleT<Mesh>> handle;
      EXPECT_TRUE(decimater.add(handle));
      if (set_up) set_up(decimater.module(handle));
    };
  }
  std::vector<std::function<void(PairDecimaterT<Mesh>&)>> to_pair_;
  std::vector<std::function<void(BaseDecimaterT<Mesh>&)>> to_base_;
};

/// A mesh with normals, so that no module has to request and compute them.
Mesh with_normals(const IndexedMesh& shape) {
  Mesh mesh = open_mesh<Mesh>(shape);
  mesh.request_face_normals();
  mesh.update_face_normals();
  return mesh;
}

/// The order that the mesh driver promises for a foreign cost, without a queue. Every halfedge is evaluated anew after
/// each collapse.
class BruteForce : public BaseDecimaterT<Mesh> {
 public:
  explicit BruteForce(Mesh& mesh) : BaseDecimaterT<Mesh>(mesh) {}

  std::vector<Collapse> run() {
    std::vector<Collapse> collapses;
    while (const std::optional<HalfedgeHandle> best = find_best()) {
      CollapseInfo collapse(mesh(), *best);
      collapses.emplace_back(collapse.v0.idx(), collapse.v1.idx());
      preprocess_collapse(collapse);
      mesh().collapse(*best);
      for (const OpenMesh::FaceHandle f : mesh().vf_range(collapse.v1)) {
        mesh().set_normal(f, mesh().calc_face_normal(f));
      }
      postprocess_collapse(collapse);
    }
    return collapses;
  }

 private:
  std::optional<HalfedgeHandle> find_best() {
    using Key = std::tuple<double, int, int, int>;
    std::optional<std::pair<Key, HalfedgeHandle>> best;
    LinkConditionT<Mesh> link_condition(mesh());
    const FlipLimit limit(75);
    for (const HalfedgeHandle h : mesh().halfedges()) {
      const CollapseInfo collapse(mesh(), h);
      if (!link_condition(h) || !is_collapse_legal(collapse)) continue;
      const float priority = collapse_priority(collapse);
      const auto position = [this](VertexHandle v) { return to_vec3(mesh().point(v)); };
      if (!(priority >= 0)) continue;
      if (any_moved_face(mesh(), collapse, to_vec3(collapse.p1), position, turns_beyond(limit))) continue;
      const auto [low, high] = std::minmax({collapse.v0.idx(), collapse.v1.idx()});
      const Key key(priority, low, high, collapse.v1.idx());
      if (!best || key < best->first) best.emplace(key, h);
    }
    if (!best) return std::nullopt;
    return best->second;
  }
};

struct ForeignCase {
  std::string name;
  Modules modules;
  friend std::ostream& operator<<(std::ostream& out, const ForeignCase& c) { return out << c.name; }
};

std::vector<ForeignCase> foreign_cases() {
  const auto by_length = Modules::with<ModEdgeLengthT>([](auto& m) {
    m.set_binary(false);
    m.set_edge_length(3);
  });
  const auto by_quadric = Modules::with<ModQuadricT>();
  return {{"ModEdgeLength", by_length},
          {"ModQuadric", by_quadric},
          {"ModRoundness", Modules::with<ModRoundnessT>()},
          {"ModAspectRatio", Modules::with<ModAspectRatioT>([](auto& m) {
             m.set_binary(false);
             m.set_aspect_ratio(12);
           })},
          {"ModQuadric, ModNormalFlipping",
           by_quadric.and_with<ModNormalFlippingT>([](auto& m) { m.set_max_normal_deviation(30); })},
          {"ModQuadric, ModAspectRatio", by_quadric.and_with<ModAspectRatioT>([](auto& m) { m.set_aspect_ratio(4); })},
          {"ModQuadric, ModHausdorff", by_quadric.and_with<ModHausdorffT>([](auto& m) { m.set_tolerance(0.1); })},
          {"ModEdgeLength, ModNormalDeviation",
           by_length.and_with<ModNormalDeviationT>([](auto& m) { m.set_normal_deviation(60); })},
          {"ModEdgeLength, ModHausdorff", by_length.and_with<ModHausdorffT>([](auto& m) { m.set_tolerance(0.2); })},
          {"ModQuadric, ModIndependentSets", by_quadric.and_with<ModIndependentSetsT>()}};
}

class ForeignModules : public testing::TestWithParam<ForeignCase> {};
INSTANTIATE_TEST_SUITE_P(Modules, ForeignModules, testing::ValuesIn(foreign_cases()), [](const auto& test) {
  std::string name = test.param.name;
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

TEST_P(ForeignModules, CollapseAsByBruteForce) {
  const std::vector<std::pair<std::string, IndexedMesh>> shapes = {{"noisy_sphere", noisy_sphere(2, 0.08, 7)},
                                                                   {"torus", torus(14, 8)},
                                                                   {"noisy_grid", noisy_grid(9, 9, 0.3, 5)},
                                                                   {"bracket", bracket(2)},
                                                                   {"open_cylinder", open_cylinder(12, 5)}};
  std::size_t n_total = 0;
  for (const auto& entry : shapes) {  // no structured binding: Clang 14 can't capture one
    const std::string& name = entry.first;
    const IndexedMesh& shape = entry.second;
    Mesh expected_mesh = with_normals(shape);
    BruteForce brute_force(expected_mesh);
    GetParam().modules.add_to(brute_force);
    ASSERT_TRUE(brute_force.initialize());
    const std::vector<Collapse> expected = brute_force.run();

    Mesh mesh = with_normals(shape);
    PairDecimaterT<Mesh> decimater(mesh);
    GetParam().modules.add_to(decimater);
    std::vector<Collapse> collapses;
    decimater.set_listener([&](const Contraction& made) {
      collapses.emplace_back(made.removed, made.survivor);
      EXPECT_EQ(made.position, shape.positions[made.survivor]) << "v1 moved";
    });
    ASSERT_TRUE(decimater.initialize());
    decimater.decimate();
    EXPECT_EQ(decimater.last_driver(), Driver::mesh);
    EXPECT_EQ(collapses, expected) << name;
    expect_sound(mesh, name);
    expect_same_topology(shape, geometry_of(mesh), name);
    n_total += expected.size();
  }
  EXPECT_GT(n_total, 50U) << "the modules forbid nearly everything";
}

TEST(ForeignGuards, AreAskedAboutBothStarsAndCounted) {
  // ModNormalFlipping looks at v0's faces with v0 moved to p1, but here the merged vertex moves. With 20 degrees it is
  // the stricter guard: no face may turn further, at either vertex.
  Mesh mesh = with_normals(noisy_torus(40, 20, 1, 0.4, 0.04, 2));
  PairDecimaterT<Mesh> decimater(mesh);
  ModGarlandHeckbertT<Mesh>::Handle cost;
  ModNormalFlippingT<Mesh>::Handle flipping;
  decimater.add(cost);
  decimater.add(flipping);
  decimater.module(flipping).set_max_normal_deviation(20);
  std::map<int, Mesh::Normal> before;
  const auto take_normals = [&] {
    for (const OpenMesh::FaceHandle f : mesh.faces()) before[f.idx()] = mesh.calc_face_normal(f);
  };
  take_normals();
  double worst_cosine = 1;
  decimater.set_listener([&](const Contraction&) {
    for (const OpenMesh::FaceHandle f : mesh.faces()) {
      worst_cosine = std::min(worst_cosine, before.at(f.idx()) | mesh.calc_face_normal(f));
    }
    take_normals();
  });
  ASSERT_TRUE(decimater.initialize());
  EXPECT_EQ(decimater.decimate(500), 500U);
  EXPECT_GE(worst_cosine, std::cos(20.0001 * std::numbers::pi / 180));
  EXPECT_LT(worst_cosine, std::cos(19.0 * std::numbers::pi / 180)) << "nothing came near the limit";
  ASSERT_EQ(decimater.module_refusals().size(), 1U);
  EXPECT_EQ(decimater.module_refusals()[0].module, "NormalFlipping");
  EXPECT_GT(decimater.module_refusals()[0].count, 10U);
}

TEST(ForeignGuards, EveryBinaryModuleOfOpenMeshRunsBesideOurCost) {
  const auto ours = Modules::with<ModGarlandHeckbertT>();
  const std::vector<ForeignCase> cases = {
      {"ModAspectRatio", ours.and_with<ModAspectRatioT>([](auto& m) { m.set_aspect_ratio(5); })},
      {"ModEdgeLength", ours.and_with<ModEdgeLengthT>([](auto& m) {
         m.set_binary(true);
         m.set_edge_length(0.3F);
       })},
      {"ModHausdorff", ours.and_with<ModHausdorffT>([](auto& m) { m.set_tolerance(0.03); })},
      {"ModIndependentSets", ours.and_with<ModIndependentSetsT>()},
      {"ModNormalDeviation", ours.and_with<ModNormalDeviationT>([](auto& m) { m.set_normal_deviation(40); })},
      {"ModQuadric", ours.and_with<ModQuadricT>([](auto& m) { m.set_max_err(1e-4); })},
      {"ModRoundness", ours.and_with<ModRoundnessT>([](auto& m) { m.set_min_roundness(0.4F, true); })}};
  const IndexedMesh shape = noisy_torus(32, 16, 1, 0.4, 0.02, 5);
  Mesh plain_mesh = with_normals(shape);
  PairDecimaterT<Mesh> plain(plain_mesh);
  ours.add_to(plain);
  ASSERT_TRUE(plain.initialize());
  const std::size_t n_without = plain.decimate();
  for (const auto& [name, modules] : cases) {
    Mesh mesh = with_normals(shape);
    PairDecimaterT<Mesh> decimater(mesh);
    modules.add_to(decimater);
    ASSERT_TRUE(decimater.initialize()) << name;
    EXPECT_GT(decimater.decimate(), 10U) << name;
    EXPECT_LT(decimater.result().n_contractions, n_without) << name << " refused nothing";
    expect_sound(mesh, name);
    expect_same_topology(shape, geometry_of(mesh), name);
  }
}

TEST(ForeignGuards, ModHausdorffStaysWithinItsTolerance) {
  // ModHausdorff promises that each removed vertex lies within the tolerance of a face around the vertex it merged
  // into. On a sphere that bounds how far the faces sink.
  Mesh mesh = with_normals(sphere(3));
  PairDecimaterT<Mesh> decimater(mesh);
  ModGarlandHeckbertT<Mesh>::Handle cost;
  ModHausdorffT<Mesh>::Handle hausdorff;
  decimater.add(cost);
  decimater.add(hausdorff);
  decimater.module(hausdorff).set_tolerance(0.02);
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate(), 300U);
  for (const OpenMesh::FaceHandle f : mesh.faces()) {
    const auto corners = face_corners(mesh, f);
    Vec3 center = Vec3::Zero();
    for (const VertexHandle v : corners) center += to_vec3(mesh.point(v)) / 3;
    EXPECT_NEAR(center.norm(), 1, 0.1);
  }
}

TEST(ForeignCosts, ModQuadricRanksAloneEvenIfItIsBinary) {
  const auto run = [](bool is_binary) {
    Mesh mesh = with_normals(blob(3, 8));
    PairDecimaterT<Mesh> decimater(mesh);
    ModQuadricT<Mesh>::Handle quadric;
    decimater.add(quadric);
    decimater.module(quadric).set_max_err(1e-4, is_binary);
    EXPECT_EQ(decimater.module(quadric).is_binary(), is_binary);
    std::vector<std::pair<Index, Index>> made;
    decimater.set_listener([&](const Contraction& c) { made.emplace_back(c.survivor, c.removed); });
    EXPECT_TRUE(decimater.initialize());
    decimater.decimate();
    return made;
  };
  const auto expected = run(false);
  EXPECT_GT(expected.size(), 50U);
  EXPECT_EQ(run(true), expected);
}

TEST(ForeignCosts, OnlySelectedAndLockedLookAtTheRemovedVertex) {
  const IndexedMesh shape = noisy_grid(16, 16, 0.2, 9);
  Mesh mesh = with_normals(shape);
  PairDecimaterT<Mesh> decimater(mesh);
  ModQuadricT<Mesh>::Handle quadric;
  decimater.add(quadric);
  for (const VertexHandle v : mesh.vertices()) {
    mesh.status(v).set_selected(v.idx() % 2 == 0);
    mesh.status(v).set_locked(v.idx() % 8 == 0);
  }
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate(0, true), 50U);
  EXPECT_GT(decimater.result().refusals[Refusal::locked], 0U);
  for (int v = 0; v < static_cast<int>(mesh.n_vertices()); ++v) {
    const bool may_vanish = v % 2 == 0 && v % 8 != 0;
    EXPECT_TRUE(may_vanish || !mesh.status(VertexHandle(v)).deleted()) << v;
  }
}

TEST(ForeignCosts, TheBorderStaysTheBorder) {
  // All edges are short and the cost ignores borders: OpenMesh's rules keep them.
  const IndexedMesh shape = noisy_grid(12, 12, 0.01, 3);
  Mesh mesh = with_normals(shape);
  PairDecimaterT<Mesh> decimater(mesh);
  ModEdgeLengthT<Mesh>::Handle length;
  decimater.add(length);
  decimater.module(length).set_binary(false);
  decimater.module(length).set_edge_length(4);
  decimater.set_listener([&](const Contraction& made) {
    const auto on_border = [&shape](Index v) {
      const Vec3& p = shape.positions[v];
      return p.x() == 0 || p.x() == 12 || p.y() == 0 || p.y() == 12;
    };
    EXPECT_TRUE(!on_border(made.removed) || on_border(made.survivor)) << made.removed << " into " << made.survivor;
  });
  ASSERT_TRUE(decimater.initialize());
  EXPECT_GT(decimater.decimate(), 80U);
}

}  // namespace
}  // namespace whittle::test
