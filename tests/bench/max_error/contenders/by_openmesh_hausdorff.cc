#include "bench/peers/openmesh_mesh.hh"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "bench/max_error/contenders/contender.hh"

// OpenMesh's DecimaterT with ModQuadric, whose error isn't limited, ModNormalFlipping, and ModHausdorff, which limits
// the distance of the input's vertices from the result. On its default mesh (float).

namespace whittle::bench {

IndexedMesh by_openmesh_hausdorff(const IndexedMesh& input, double length) {
  OpenMeshMesh mesh;
  fill(mesh, input);
  mesh.request_face_normals();
  mesh.update_face_normals();
  {
    OpenMesh::Decimater::DecimaterT<OpenMeshMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<OpenMeshMesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<OpenMeshMesh>::Handle flipping;
    OpenMesh::Decimater::ModHausdorffT<OpenMeshMesh>::Handle hausdorff;
    decimater.add(quadric);
    decimater.add(flipping);
    decimater.add(hausdorff);
    decimater.module(quadric).unset_max_err();
    decimater.module(hausdorff).set_tolerance(static_cast<float>(length));
    decimater.initialize();
    decimater.decimate_to_faces(0, 1);
  }
  mesh.garbage_collection();
  return geometry_of(mesh);
}

}  // namespace whittle::bench
