#include "bench/peers/openmesh_mesh.hh"
#include "bench/peers/peer.hh"
#include "whittle/openmesh/garbage_collection.hh"
#include "whittle/openmesh/mod_garland_heckbert.hh"
#include "whittle/openmesh/pair_decimater.hh"

// Whittle's decimater for OpenMesh meshes, with garbage collection, on one thread. With its defaults it uses the engine
// driver.

namespace whittle::bench {
namespace {

class PairDecimater : public Peer {
 public:
  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    OpenMeshMesh mesh;
    fill(mesh, input);

    meter.start();
    {
      PairDecimaterT<OpenMeshMesh> decimater(mesh);
      ModGarlandHeckbertT<OpenMeshMesh>::Handle quadric;
      decimater.add(quadric);
      decimater.set_threads(1);
      decimater.initialize();
      decimater.decimate_to_faces(0, n_faces);
    }
    collect_garbage(mesh);
    meter.stop();
    return geometry_of(mesh);
  }

  bool is_ours() const override { return true; }
};

}  // namespace

std::unique_ptr<Peer> make_pair_decimater() { return std::make_unique<PairDecimater>(); }

}  // namespace whittle::bench
