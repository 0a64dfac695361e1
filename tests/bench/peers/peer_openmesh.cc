#include "bench/peers/openmesh_mesh.hh"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "bench/peers/peer.hh"

// OpenMesh's stock DecimaterT with ModQuadric and ModNormalFlipping at its default angle, on its default mesh (float).

namespace whittle::bench {
namespace {

class OpenMeshPeer : public Peer {
 public:
  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    OpenMeshMesh mesh;
    fill(mesh, input);
    mesh.request_face_normals();
    mesh.update_face_normals();

    meter.start();
    {
      OpenMesh::Decimater::DecimaterT<OpenMeshMesh> decimater(mesh);
      OpenMesh::Decimater::ModQuadricT<OpenMeshMesh>::Handle quadric;
      OpenMesh::Decimater::ModNormalFlippingT<OpenMeshMesh>::Handle flipping;
      decimater.add(quadric);
      decimater.add(flipping);
      decimater.initialize();
      decimater.decimate_to_faces(0, n_faces);
    }
    mesh.garbage_collection();
    meter.stop();
    return geometry_of(mesh);
  }
};

}  // namespace

std::unique_ptr<Peer> make_openmesh() { return std::make_unique<OpenMeshPeer>(); }

}  // namespace whittle::bench
