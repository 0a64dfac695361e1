// ModRecorderT: the steps of a decimater, for Replay and for OpenMesh's own progressive meshes.
#include <gtest/gtest.h>

#include <algorithm>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/MixedDecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModProgMeshT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <fstream>
#include <iterator>
#include <whittle/openmesh/mod_garland_heckbert.hh>
#include <whittle/openmesh/mod_recorder.hh>
#include <whittle/openmesh/pair_decimater.hh>
#include <whittle/progressive/replay.hh>

#include "common/modules.hh"
#include "support/shapes/shapes.hh"
#include "support/temporary_folder.hh"

namespace whittle::test {
namespace {

using OpenMesh::Decimater::DecimaterT;
using OpenMesh::Decimater::ModProgMeshT;
using OpenMesh::Decimater::ModQuadricT;

/// Faces from the lowest corner on: OpenMesh begins them anywhere.
std::vector<Triangle> turned(std::vector<Triangle> faces) {
  for (Triangle& face : faces) std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return faces;
}

void expect_same(const IndexedMesh& replayed, const IndexedMesh& mesh, const std::string& what) {
  EXPECT_EQ(replayed.positions, mesh.positions) << what;
  EXPECT_EQ(turned(replayed.faces), turned(mesh.faces)) << what;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs a decimater to a third of the faces, and replays what it did, forwards and backwards.
template <template <class> class Decimater, template <class> class Cost>
void expect_replays(const NamedMesh& shape) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(shape.mesh);
  const IndexedMesh before = geometry_of(mesh, Copies::apart);
  Decimater<DoubleMesh> decimater(mesh);
  typename Cost<DoubleMesh>::Handle cost;
  typename whittle::ModRecorderT<DoubleMesh>::Handle recorder;
  decimater.add(recorder);
  decimater.add(cost);
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, shape.mesh.faces.size() / 3 + 1);
  whittle::ModRecorderT<DoubleMesh>& module = decimater.module(recorder);
  progressive::Replay replay(module.input(), module.steps());
  expect_same(replay.decimation().mesh, geometry_of(mesh, Copies::apart), shape.name);
  replay.go_to(0);
  expect_same(replay.decimation().mesh, before, shape.name + ", the input");
}

TEST(ModRecorder, FollowsOpenMeshesDecimater) {
  for (const NamedMesh& shape : holdable_meshes()) {
    expect_replays<DecimaterT, ModQuadricT>(shape);
    expect_replays<DecimaterT, ModGarlandHeckbertT>(shape);
  }
}

TEST(ModRecorder, FollowsPairDecimater) {
  for (const NamedMesh& shape : holdable_meshes()) expect_replays<PairDecimaterT, ModGarlandHeckbertT>(shape);
}

/// Collecting the garbage on the way gives vertices other handles.
TEST(ModRecorder, FollowsADecimaterThatCollectsGarbage) {
  DoubleMesh mesh = open_mesh<DoubleMesh>(sphere(3));
  OpenMesh::Decimater::MixedDecimaterT<DoubleMesh> decimater(mesh);
  ModGarlandHeckbertT<DoubleMesh>::Handle cost;
  whittle::ModRecorderT<DoubleMesh>::Handle recorder;
  decimater.add(recorder);
  decimater.add(cost);
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate_to_faces(0, 200);
  whittle::ModRecorderT<DoubleMesh>& module = decimater.module(recorder);
  const progressive::Replay replay(module.input(), module.steps());
  const auto sorted = [](std::vector<Vec3> positions) {
    std::sort(positions.begin(), positions.end(), [](const Vec3& a, const Vec3& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return positions;
  };
  const IndexedMesh replayed = replay.decimation().mesh;
  const IndexedMesh left = geometry_of(mesh, Copies::apart);
  EXPECT_EQ(sorted(replayed.positions), sorted(left.positions));
  EXPECT_EQ(replayed.faces.size(), left.faces.size());
  const TemporaryFolder folder;
  EXPECT_THROW(module.write_pm(folder / "mixed.pm"), std::logic_error);
}

TEST(ModRecorder, WritesTheFileOfModProgMesh) {
  const TemporaryFolder folder;
  for (const NamedMesh& shape : holdable_meshes()) {
    FloatMesh mesh = open_mesh<FloatMesh>(shape.mesh);
    DecimaterT<FloatMesh> decimater(mesh);
    ModQuadricT<FloatMesh>::Handle cost;
    whittle::ModRecorderT<FloatMesh>::Handle recorder;
    ModProgMeshT<FloatMesh>::Handle progressive;
    decimater.add(cost);
    decimater.add(recorder);
    decimater.add(progressive);
    ASSERT_TRUE(decimater.initialize());
    decimater.decimate_to_faces(0, shape.mesh.faces.size() / 3 + 1);
    ASSERT_TRUE(decimater.module(progressive).write(folder / "theirs.pm"));
    decimater.module(recorder).write_pm(folder / "ours.pm");
    EXPECT_EQ(bytes_of(folder / "ours.pm"), bytes_of(folder / "theirs.pm")) << shape.name;
  }
}

TEST(ModRecorder, RefusesAFileForVerticesThatHaveMoved) {
  const TemporaryFolder folder;
  FloatMesh mesh = open_mesh<FloatMesh>(sphere(3));
  DecimaterT<FloatMesh> decimater(mesh);
  ModGarlandHeckbertT<FloatMesh>::Handle cost;
  whittle::ModRecorderT<FloatMesh>::Handle recorder;
  decimater.add(cost);
  decimater.add(recorder);
  ASSERT_TRUE(decimater.initialize());
  decimater.decimate(10);
  EXPECT_THROW(decimater.module(recorder).write_pm(folder / "moved.pm"), std::logic_error);
  EXPECT_FALSE(std::filesystem::exists(folder / "moved.pm"));
}

}  // namespace
}  // namespace whittle::test
