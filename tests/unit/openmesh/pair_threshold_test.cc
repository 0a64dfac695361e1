// Threshold pairs on OpenMesh meshes, and meshes with copies. The result is an ordinary half-edge mesh that holds what
// the engine made of the indexed mesh.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>  // before OpenMesh's headers, which use std::find without it

#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#include <whittle/io/read.hh>
#include <whittle/openmesh/garbage_collection.hh>

#include "common/decimation.hh"
#include "common/meshes.hh"
#include "common/same_mesh.hh"
#include "support/meshes.hh"
#include "support/random.hh"
#include "support/shapes/shapes.hh"
#include "support/suites.hh"
#include "support/transforms.hh"

namespace whittle::test {
namespace {

using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;
using testing::HasSubstr;

/// A mesh, cut if necessary, and a decimater with a threshold.
template <class MeshT>
struct PairRun {
  PairRun(const IndexedMesh& shape, double threshold) : mesh(cut(shape)), decimater(mesh) {
    mesh.request_halfedge_status();
    decimater.add(cost);
    decimater.set_pair_threshold(threshold);
    decimater.set_listener([this](const Contraction& made) { contractions.push_back(made); });
    EXPECT_TRUE(decimater.initialize());
  }
  static MeshT cut(const IndexedMesh& shape) {
    MeshT result;
    EXPECT_TRUE(to_open_mesh(shape, result).empty());
    return result;
  }

  MeshT mesh;
  PairDecimaterT<MeshT> decimater;
  typename ModGarlandHeckbertT<MeshT>::Handle cost;
  std::vector<Contraction> contractions;
};

whittle::Decimation by_engine(const IndexedMesh& shape, double threshold, const DecimateTarget& target,
                              std::vector<Contraction>* contractions = nullptr) {
  DecimateOptions options;
  options.pairs.threshold = threshold;
  if (contractions) options.listener = [=](const Contraction& made) { contractions->push_back(made); };
  return whittle::decimate(shape, target, options);
}

template <class MeshT>
void expect_manifold(const MeshT& mesh, const std::string& context) {
  expect_sound(mesh, context);
  for (const VertexHandle v : mesh.vertices()) ASSERT_TRUE(mesh.is_manifold(v)) << context << ": vertex " << v.idx();
}

template <class MeshT>
std::size_t n_further_copies(const MeshT& mesh) {
  return geometry_of(mesh, Copies::apart).positions.size() - geometry_of(mesh).positions.size();
}

struct Case {
  std::string name;
  IndexedMesh mesh;
  double threshold;
};

/// Parts that lie close together.
std::vector<Case> gapped() {
  return {{"two spheres", spheres(2, 3, 0.02), 0.15},
          {"boxes(10, 10)", boxes(10, 10, 0.2), 0.25},
          {"boxes(4, 4), pairs across their sides", boxes(4, 4, 0.2), 2.1},
          {"three blobs",
           joined(blob(2, 1), joined(moved(blob(2, 2), Vec3(1.9, 0, 0)), moved(blob(2, 3), Vec3(0, 2, 0)))), 0.4},
          {"sheets", joined(noisy_grid(12, 12, 0.1, 1), moved(noisy_grid(12, 12, 0.1, 2), Vec3(0, 0, 0.4))), 0.5},
          {"the same sheet twice", joined(noisy_grid(9, 9, 0.1, 1), noisy_grid(9, 9, 0.1, 1)), 0.1},
          {"back to back", joined(sphere(2), inside_out(sphere(2))), 0.01},
          {"soup", soup(blob(2, 5)), 1e-6},
          {"halves", joined(noisy_grid(8, 8, 0.2, 3), moved(noisy_grid(8, 8, 0.2, 3), Vec3(8.05, 0, 0))), 0.1}};
}

/// Non-manifold meshes, without and with a threshold.
std::vector<Case> nonmanifold() {
  std::vector<Case> result;
  for (const double threshold : {0.0, 0.3}) {
    for (NamedMesh& entry : nonmanifold_meshes()) result.push_back({entry.name, entry.mesh, threshold});
    result.push_back({"spheres that touch", glued(spheres(3, 2, 0)), threshold});
    result.push_back({"boxes that touch", glued(boxes(3, 3, 0)), threshold});
    result.push_back({"two_cubes_on_an_edge(5)", two_cubes_on_an_edge(5), threshold});
    result.push_back({"book(4, 9)", book(4, 9), threshold});
  }
  return result;
}

/// Runs on an OpenMesh mesh and on plain arrays, and compares. \return the number of contracted threshold pairs
std::uint64_t expect_as_by_engine(const Case& c, const DecimateTarget& target, const std::string& what) {
  const std::string context = c.name + ", threshold " + std::to_string(c.threshold) + ", " + what;
  std::vector<Contraction> contractions;
  const whittle::Decimation expected = by_engine(c.mesh, c.threshold, target, &contractions);
  PairRun<DoubleMesh> run(c.mesh, c.threshold);
  const DecimateResult result = run.decimater.decimate(target);
  EXPECT_EQ(run.decimater.last_driver(), Driver::engine) << context;
  expect_same_contractions(contractions, run.contractions, context);
  EXPECT_EQ(result.n_faces, expected.result.n_faces) << context;
  EXPECT_EQ(result.n_vertices, expected.result.n_vertices) << context;
  EXPECT_EQ(result.threshold_pairs.contracted, expected.result.threshold_pairs.contracted) << context;

  expect_manifold(run.mesh, context);
  const IndexedMesh after = geometry_of(run.mesh);
  EXPECT_EQ(after.faces, expected.mesh.faces) << context;
  EXPECT_TRUE(after.positions == expected.mesh.positions) << context;
  EXPECT_TRUE(topology(geometry_of(run.mesh, Copies::apart)).manifold()) << context;

  collect_garbage(run.mesh);
  expect_manifold(run.mesh, context + ", collected");
  EXPECT_EQ(topology(geometry_of(run.mesh)), topology(expected.mesh)) << context << ", collected";
  return result.threshold_pairs.contracted;
}

TEST(PairThreshold, LeavesAHalfEdgeMeshOfTheEnginesResult) {
  for (const Case& c : gapped()) {
    std::uint64_t n_threshold_pairs = 0;
    for (const double share : {0.9, 0.5, 0.1, 0.0}) {
      const auto n_faces = static_cast<std::uint64_t>(share * static_cast<double>(c.mesh.faces.size()));
      n_threshold_pairs += expect_as_by_engine(c, to_faces(n_faces), "to " + std::to_string(n_faces) + " faces");
    }
    EXPECT_GT(n_threshold_pairs, 0U) << c.name << ": nothing was tested";
  }
}

TEST(PairThreshold, MeshesWithCopiesAreDecimatedAsOne) {
  for (const Case& c : nonmanifold()) {
    for (const double share : {1.0, 0.6, 0.0}) {
      const auto n_faces = static_cast<std::uint64_t>(share * static_cast<double>(c.mesh.faces.size()));
      expect_as_by_engine(c, to_faces(n_faces), "to " + std::to_string(n_faces) + " faces");
    }
  }
}

/// Two sheets that share some border vertices.
IndexedMesh touching_sheets(std::uint64_t seed) {
  Random random(seed);
  const IndexedMesh first = noisy_grid(5, 5, 0.3, seed);
  IndexedMesh second = moved(noisy_grid(5, 5, 0.3, seed + 100), Vec3(0, -5.5, 0));
  for (std::uint64_t i = 0; i < 2 + seed % 5; ++i)
    second.positions[30 + random.below(6)] = first.positions[random.below(6)];
  return glued(joined(first, second));
}

void expect_no_edge_twice(const DoubleMesh& mesh, const std::string& context) {
  std::set<std::pair<int, int>> edges;
  for (const OpenMesh::EdgeHandle e : mesh.edges()) {
    const OpenMesh::HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    const std::pair<int, int> ends = std::minmax(mesh.to_vertex_handle(h).idx(), mesh.from_vertex_handle(h).idx());
    ASSERT_TRUE(edges.insert(ends).second) << context << ": two edges between the same vertices";
  }
}

TEST(PairThreshold, SheetsThatTouchAreLeftAsTheyAreOrCut) {
  // OpenMesh can hold vertices with several open fans without copies, but the engine joins the fans in rare cases.
  int n_cut = 0;
  int n_left = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const IndexedMesh shape = touching_sheets(seed);
    DoubleMesh whole;
    if (!to_open_mesh(shape, whole, NonManifold::refuse).empty()) continue;
    for (const std::uint64_t n_faces : {80U, 40U, 20U, 0U}) {
      const std::string context = "seed " + std::to_string(seed) + ", to " + std::to_string(n_faces) + " faces";
      DoubleMesh mesh = whole;
      PairDecimaterT<DoubleMesh> decimater(mesh);
      ModGarlandHeckbertT<DoubleMesh>::Handle cost;
      decimater.add(cost);
      ASSERT_TRUE(decimater.initialize());
      decimater.decimate(to_faces(n_faces));
      EXPECT_EQ(decimater.last_driver(), Driver::engine);
      expect_sound(mesh, context);
      expect_no_edge_twice(mesh, context);
      const whittle::Decimation expected = by_engine(shape, 0, to_faces(n_faces));
      EXPECT_EQ(geometry_of(mesh).faces, expected.mesh.faces) << context;
      EXPECT_TRUE(geometry_of(mesh).positions == expected.mesh.positions) << context;
      ++(find_copies_property(mesh).is_valid() ? n_cut : n_left);
    }
  }
  EXPECT_GT(n_cut, 0);  // rare: the engine keeps the Euler number at such vertices
  EXPECT_GT(n_left, 1000);
}

TEST(PairThreshold, HoldsOnRealMeshes) {
  for (const auto& [file, threshold] :
       {std::pair("synthetic/synth_two_spheres_gap0.01.obj", 0.05),
        std::pair("synthetic/synth_cubes_10x10_gap10pct.obj", 0.15), std::pair("nasty/triple_vierbein.obj", 0.1)}) {
    WHITTLE_REAL_MESH_OR_SKIP(path, file);
    IndexedMesh mesh = io::read_mesh(path).mesh;
    mesh.origins.clear();
    const std::size_t n_faces = mesh.faces.size();
    expect_as_by_engine({file, mesh, threshold * diagonal(mesh)}, to_faces(n_faces / 10), "to a tenth");
  }
}

TEST(PairThreshold, WithoutAPairWithinItChangesNothing) {
  for (const auto& [name, shape] : {NamedMesh{"boxes", boxes(3, 3)}, NamedMesh{"terrain", terrain(12, 3)}}) {
    DoubleMesh meshes[2];
    for (int i = 0; i < 2; ++i) {
      PairRun<DoubleMesh> run(shape, i == 0 ? 0 : 1e-9);
      run.decimater.decimate_to(shape.positions.size() / 2);
      meshes[i] = run.mesh;
    }
    expect_same_mesh(meshes[0], meshes[1], name);
    EXPECT_FALSE(find_copies_property(meshes[1]).is_valid()) << name;
  }
}

TEST(PairThreshold, SurvivorsKeepHandlesAndPropertiesAndCopiesHaveThem) {
  for (const Case& c : gapped()) {
    PairRun<DoubleMesh> run(c.mesh, c.threshold);
    DoubleMesh& mesh = run.mesh;
    OpenMesh::VProp<int> vertex_number(mesh);
    OpenMesh::FProp<int> face_number(mesh);
    for (const VertexHandle v : mesh.vertices()) vertex_number[v] = v.idx() * 3;
    for (const FaceHandle f : mesh.faces()) face_number[f] = f.idx() * 5;
    const auto n_before = static_cast<int>(mesh.n_vertices());
    run.decimater.decimate_to_faces(0, c.mesh.faces.size() / 2);

    const std::vector<Index> firsts = first_copies(mesh);
    for (const VertexHandle v : mesh.vertices()) {
      const int first = firsts.empty() ? v.idx() : static_cast<int>(firsts[static_cast<std::size_t>(v.idx())]);
      EXPECT_EQ(vertex_number[v], 3 * (v.idx() < n_before ? v.idx() : first)) << c.name;
      EXPECT_EQ(mesh.point(v), mesh.point(VertexHandle(first))) << c.name;
    }
    for (const FaceHandle f : mesh.faces()) EXPECT_EQ(face_number[f], f.idx() * 5) << c.name;
    for (const Contraction& made : run.contractions) {
      EXPECT_TRUE(mesh.status(VertexHandle(static_cast<int>(made.removed))).deleted()) << c.name;
    }
    EXPECT_EQ(mesh.n_faces(), c.mesh.faces.size()) << c.name << ": faces are marked, not removed";
  }
}

TEST(PairThreshold, FaceNormalsAreRightAtTheEnd) {
  for (const Case& c : gapped()) {
    PairRun<DoubleMesh> run(c.mesh, c.threshold);
    run.mesh.request_face_normals();
    run.mesh.update_face_normals();
    run.decimater.decimate_to_faces(0, c.mesh.faces.size() / 2);
    for (const FaceHandle f : run.mesh.faces()) {
      EXPECT_EQ(run.mesh.normal(f), run.mesh.calc_face_normal(f)) << c.name;
    }
  }
}

TEST(PairThreshold, FloatMeshesAreRoundedOnWriteBackOnlyAndCopiesTheSame) {
  const IndexedMesh shape = moved(spheres(2, 3, 0.02), Vec3(0.3, 7, 1));
  PairRun<FloatMesh> run(shape, 0.15);
  const IndexedMesh input = geometry_of(run.mesh);
  run.decimater.decimate(to_faces(300));
  const whittle::Decimation expected = by_engine(input, 0.15, to_faces(300));
  expect_manifold(run.mesh, "float");
  const IndexedMesh after = geometry_of(run.mesh);
  EXPECT_EQ(after.faces, expected.mesh.faces);
  ASSERT_EQ(after.positions.size(), expected.mesh.positions.size());
  for (std::size_t v = 0; v < after.positions.size(); ++v) {
    EXPECT_EQ(after.positions[v], expected.mesh.positions[v].cast<float>().cast<double>()) << v;
  }
}

TEST(PairThreshold, LockedAndUnselectedVerticesKeepEveryBit) {
  const Case c = gapped()[0];
  for (const bool only_selected : {false, true}) {
    PairRun<DoubleMesh> run(c.mesh, c.threshold);
    const auto is_fixed = [&](VertexHandle v) { return v.idx() % 4 == 1; };
    for (const VertexHandle v : run.mesh.vertices()) {
      if (only_selected) {
        run.mesh.status(v).set_selected(!is_fixed(v));
      } else {
        run.mesh.status(v).set_locked(is_fixed(v));
      }
    }
    const DecimateResult result = run.decimater.decimate(DecimateTarget::as_far_as_possible(), only_selected);
    EXPECT_GT(result.threshold_pairs.contracted, 0U);
    expect_manifold(run.mesh, "locked");
    for (int i = 1; i < static_cast<int>(c.mesh.positions.size()); i += 4) {
      const VertexHandle v(i);
      EXPECT_FALSE(run.mesh.status(v).deleted()) << i;
      EXPECT_EQ(to_vec3(run.mesh.point(v)), c.mesh.positions[static_cast<std::size_t>(i)]) << i;
    }
  }
}

TEST(PairThreshold, AnAbortLeavesWhatWasContractedUpToIt) {
  for (const Case& c : gapped()) {
    PairRun<DoubleMesh> whole(c.mesh, c.threshold);
    whole.decimater.decimate(DecimateTarget::as_far_as_possible());
    const std::size_t n_all = whole.contractions.size();
    for (const std::size_t limit : {std::size_t{1}, n_all / 3, n_all - 1}) {
      const std::string context = c.name + ", aborted after " + std::to_string(limit);
      PairRun<DoubleMesh> run(c.mesh, c.threshold);
      StoppingObserver observer(limit, 1);
      run.decimater.set_observer(&observer);
      const DecimateResult result = run.decimater.decimate(DecimateTarget::as_far_as_possible());
      EXPECT_EQ(result.stop, StopReason::cancelled) << context;
      EXPECT_EQ(result.n_contractions, limit) << context;
      const auto end = whole.contractions.begin() + static_cast<std::ptrdiff_t>(limit);
      expect_same_contractions({whole.contractions.begin(), end}, run.contractions, context);
      expect_manifold(run.mesh, context);
      EXPECT_EQ(geometry_of(run.mesh).faces.size(), result.n_faces) << context;
      EXPECT_EQ(geometry_of(run.mesh).positions.size(), result.n_vertices) << context;
    }
  }
}

// Once more on a mesh with copies
// --------------------------------------------------------------------------------------

TEST(PairThreshold, InitializeAnewGoesOnFromTheIndexedMesh) {
  int n_cut = 0;
  for (const Case& c : gapped()) {
    PairRun<DoubleMesh> run(c.mesh, c.threshold);
    std::size_t most_copies = 0;
    IndexedMesh expected = c.mesh;
    for (const double share : {0.8, 0.5, 0.3, 0.1}) {
      const std::string context = c.name + ", to a share of " + std::to_string(share);
      const DecimateTarget target =
          to_faces(static_cast<std::uint64_t>(share * static_cast<double>(c.mesh.faces.size())));
      const bool has_threshold = share != 0.5;
      run.decimater.set_pair_threshold(has_threshold ? c.threshold : 0);
      ASSERT_TRUE(run.decimater.initialize());
      run.decimater.decimate(target);
      expected = by_engine(expected, has_threshold ? c.threshold : 0, target).mesh;
      expected.origins.clear();
      expect_manifold(run.mesh, context);
      const IndexedMesh after = geometry_of(run.mesh);
      EXPECT_EQ(after.faces, expected.faces) << context;
      EXPECT_TRUE(after.positions == expected.positions) << context;
      most_copies = std::max(most_copies, n_further_copies(run.mesh));
    }
    n_cut += most_copies > 0;
  }
  EXPECT_GE(n_cut, 5) << "in hardly any case vertices had to be cut";
}

TEST(PairThreshold, TheMeshDriverLeavesCopiesWhereTheyAre) {
  for (const Case& c : nonmanifold()) {
    PairRun<DoubleMesh> run(c.mesh, 0);
    run.decimater.set_driver(Driver::mesh);
    ModCollapsesT<DoubleMesh>::Handle recorder;
    run.decimater.add(recorder);
    ASSERT_TRUE(run.decimater.initialize());
    const Topology before = topology(c.mesh);
    const std::vector<Index> copies = first_copies(run.mesh);
    const DecimateResult result = run.decimater.decimate(DecimateTarget::as_far_as_possible());
    EXPECT_EQ(run.decimater.last_driver(), Driver::mesh);
    expect_sound(run.mesh, c.name);
    const IndexedMesh after = geometry_of(run.mesh);
    EXPECT_GE(topology(after).nonmanifold_edges, before.nonmanifold_edges) << c.name << ": a crack";
    EXPECT_EQ(topology(after).border_edges == 0, before.border_edges == 0) << c.name << ": a crack";
    EXPECT_EQ(first_copies(run.mesh), copies) << c.name;
    EXPECT_EQ(result.n_vertices, after.positions.size()) << c.name << ": copies count as one";
  }
}

TEST(PairThreshold, AfterwardsTheMeshDriverGoesOnWithTheQuadrics) {
  const Case c = gapped()[1];
  PairRun<DoubleMesh> run(c.mesh, c.threshold);
  run.decimater.decimate(to_faces(800));
  const std::vector<Index> copies = first_copies(run.mesh);
  ASSERT_FALSE(copies.empty()) << "nothing had to be cut";
  const auto& module = run.decimater.module(run.cost);
  for (const VertexHandle v : run.mesh.vertices()) {
    EXPECT_EQ(module.frame().to_model(module.position(v)), to_vec3(run.mesh.point(v))) << v.idx();
  }
  run.decimater.set_pair_threshold(0);
  run.decimater.set_driver(Driver::mesh);
  EXPECT_GT(run.decimater.decimate(50), 0U);
  EXPECT_EQ(run.decimater.last_driver(), Driver::mesh);
  expect_sound(run.mesh, "after the mesh driver");
  EXPECT_EQ(first_copies(run.mesh), copies);
}

// What is refused
// ------------------------------------------------------------------------------------------------------

template <class MeshT>
std::string error_of(PairDecimaterT<MeshT>& decimater) {
  try {
    decimater.decimate();
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "no exception";
}

TEST(PairThreshold, IsRefusedWhereTheEngineCannotRun) {
  const std::string refused = "only the engine driver contracts threshold pairs";
  const IndexedMesh shape = boxes(2, 2);
  PairRun<DoubleMesh> run(shape, 0.25);
  run.decimater.set_driver(Driver::mesh);
  EXPECT_THAT(error_of(run.decimater), testing::AllOf(HasSubstr(refused), HasSubstr("mesh driver was asked for")));
  run.decimater.set_driver(Driver::automatic);

  auto& cost = run.decimater.module(run.cost);
  const auto expect_plain_cost_wanted = [&] {
    ASSERT_TRUE(run.decimater.initialize());
    EXPECT_THAT(error_of(run.decimater), testing::AllOf(HasSubstr(refused), HasSubstr("plain quadric cost")));
  };
  cost.set_isotropy(0.1);
  expect_plain_cost_wanted();
  cost.set_isotropy(0);
  cost.set_valence_weight(1);
  expect_plain_cost_wanted();
  cost.set_valence_weight(0);

  ModCollapsesT<DoubleMesh>::Handle recorder;
  run.decimater.add(recorder);
  ASSERT_TRUE(run.decimater.initialize());
  EXPECT_THAT(error_of(run.decimater), testing::AllOf(HasSubstr(refused), HasSubstr("module Collapses")));
  EXPECT_EQ(geometry_of(run.mesh).faces, shape.faces) << "something was contracted";
  run.decimater.set_pair_threshold(0);
  EXPECT_EQ(run.decimater.decimate(1), 1U) << "edges honour the module";

  PairRun<DoubleMesh> twice(shape, 0.25);
  EXPECT_EQ(twice.decimater.decimate(2), 2U);
  EXPECT_EQ(twice.decimater.decimate(2), 2U) << "the engine goes on";

  DoubleMesh mesh = open_mesh<DoubleMesh>(shape);
  PairDecimaterT<DoubleMesh> foreign(mesh);
  OpenMesh::Decimater::ModQuadricT<DoubleMesh>::Handle quadric;
  foreign.add(quadric);
  foreign.set_pair_threshold(0.25);
  ASSERT_TRUE(foreign.initialize());
  EXPECT_THAT(error_of(foreign), testing::AllOf(HasSubstr(refused), HasSubstr("module Quadric")));
}

TEST(PairThreshold, IsANumberFromZeroOn) {
  PairRun<DoubleMesh> run(sphere(1), 0.5);
  EXPECT_EQ(run.decimater.pair_threshold(), 0.5);
  EXPECT_THROW(run.decimater.set_pair_threshold(-0.1), std::invalid_argument);
  EXPECT_THROW(run.decimater.set_pair_threshold(std::nan("")), std::invalid_argument);
  EXPECT_EQ(run.decimater.pair_threshold(), 0.5) << "of a refused one nothing stays";
  PairOptions options;
  options.threshold = INFINITY;
  options.max_pairs = 3;
  run.decimater.set_pair_options(options);
  EXPECT_EQ(run.decimater.pair_threshold(), INFINITY);
  run.decimater.set_pair_threshold(2);
  EXPECT_EQ(run.decimater.pair_options().max_pairs, 3U);
}

}  // namespace
}  // namespace whittle::test
