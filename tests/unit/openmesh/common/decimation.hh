#pragma once

#include <gtest/gtest.h>

#include <vector>
#include <whittle/openmesh/mod_garland_heckbert.hh>
#include <whittle/openmesh/pair_decimater.hh>

#include "meshes.hh"

namespace whittle::test {

/// A mesh with a decimater and our cost module, ready to run.
template <class MeshT>
struct Decimation {
  explicit Decimation(const IndexedMesh& shape, Driver driver = Driver::automatic)
      : mesh(open_mesh<MeshT>(shape)), decimater(mesh) {
    decimater.add(cost);
    decimater.set_driver(driver);
    decimater.set_listener([this](const Contraction& made) { contractions.push_back(made); });
    EXPECT_TRUE(decimater.initialize());
  }
  ModGarlandHeckbertT<MeshT>& module() { return decimater.module(cost); }

  MeshT mesh;
  PairDecimaterT<MeshT> decimater;
  typename ModGarlandHeckbertT<MeshT>::Handle cost;
  std::vector<Contraction> contractions;
};

/// Whether v still exists, at the same position.
template <class MeshT>
bool unmoved(const MeshT& mesh, const IndexedMesh& before, OpenMesh::VertexHandle v) {
  return !mesh.status(v).deleted() && to_vec3(mesh.point(v)) == before.positions[static_cast<std::size_t>(v.idx())];
}

/// Base class of the tests that run with both drivers.
class EachDriver : public testing::TestWithParam<Driver> {};
inline const auto each_driver = testing::Values(Driver::engine, Driver::mesh);
inline std::string driver_name(const testing::TestParamInfo<Driver>& test) {
  return test.param == Driver::engine ? "Engine" : "Mesh";
}

}  // namespace whittle::test
