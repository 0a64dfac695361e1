#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <whittle/openmesh/mod_garland_heckbert.hh>
#include <whittle/openmesh/mod_lindstrom_turk.hh>
#include <whittle/openmesh/mod_max_error.hh>
#include <whittle/openmesh/mod_memoryless.hh>
#include <whittle/openmesh/mod_midpoint.hh>
#include <whittle/openmesh/mod_valence.hh>
#include <whittle/openmesh/pair_decimater.hh>

// The meshes of these tests. What the tests use of both is compiled once, in instantiations.cc.
namespace whittle::test {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using FloatMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using DoubleMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

}  // namespace whittle::test

// NOLINTBEGIN(bugprone-macro-parentheses)
#define WHITTLE_TEST_INSTANTIATE(PREFIX, TRAITS)                                                                     \
  PREFIX template class OpenMesh::AttribKernelT<OpenMesh::FinalMeshItemsT<TRAITS, true>, OpenMesh::TriConnectivity>; \
  PREFIX template class OpenMesh::PolyMeshT<                                                                         \
      OpenMesh::AttribKernelT<OpenMesh::FinalMeshItemsT<TRAITS, true>, OpenMesh::TriConnectivity>>;                  \
  PREFIX template class OpenMesh::TriMeshT<                                                                          \
      OpenMesh::AttribKernelT<OpenMesh::FinalMeshItemsT<TRAITS, true>, OpenMesh::TriConnectivity>>;                  \
  PREFIX template class OpenMesh::Decimater::BaseDecimaterT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                 \
  PREFIX template class OpenMesh::Decimater::DecimaterT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                     \
  PREFIX template class whittle::PairDecimaterT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                             \
  PREFIX template class whittle::EngineRunT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                                 \
  PREFIX template class whittle::MeshRunT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                                   \
  PREFIX template class whittle::PlacingModuleT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                             \
  PREFIX template class whittle::QuadricModuleT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                             \
  PREFIX template class whittle::ModGarlandHeckbertT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                        \
  PREFIX template class whittle::ModMemorylessT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                             \
  PREFIX template class whittle::ModLindstromTurkT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                          \
  PREFIX template class whittle::ModMidpointT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                               \
  PREFIX template class whittle::ModMaxErrorT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                               \
  PREFIX template class whittle::ModValenceT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                                \
  PREFIX template class whittle::ModFlipGuardT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;                              \
  PREFIX template class whittle::ModRadiusRatioT<OpenMesh::TriMesh_ArrayKernelT<TRAITS>>;
// NOLINTEND(bugprone-macro-parentheses)

WHITTLE_TEST_INSTANTIATE(extern, OpenMesh::DefaultTraits)
WHITTLE_TEST_INSTANTIATE(extern, whittle::test::DoubleTraits)
