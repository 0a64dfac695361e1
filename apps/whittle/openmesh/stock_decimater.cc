#include "openmesh/stock_decimater.hh"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "openmesh/double_mesh.hh"
#include "terminal/errors.hh"
#include "whittle/core/progress.hh"
#include "whittle/openmesh/conversions.hh"

namespace whittle::app {

StockRun decimate_by_stock(const IndexedMesh& input, const std::string& name, const DecimateTarget& target,
                           const std::function<void(std::uint64_t)>& progress) {
  StockRun run;
  const Stopwatch building;
  DoubleMesh mesh;
  run.n_lost_faces = to_open_mesh(input, mesh, NonManifold::refuse).size();
  const HeldStatus status(mesh);
  if (mesh.n_faces() == 0)
    throw UnsupportedMesh(name + ": OpenMesh's mesh can hold none of the faces: nothing to compare with");
  mesh.request_face_normals();
  mesh.update_face_normals();
  if (run.n_lost_faces > 0) {
    mesh.delete_isolated_vertices();  // otherwise they would count towards the target
    mesh.garbage_collection();
  }
  run.seconds_build = building.seconds();

  const Stopwatch decimating;
  {
    OpenMesh::Decimater::DecimaterT<DoubleMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<DoubleMesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<DoubleMesh>::Handle flipping;
    decimater.add(quadric);
    decimater.add(flipping);
    if (target.cost_limit()) decimater.module(quadric).set_max_err(*target.cost_limit(), false);
    ContractionObserver observer([&progress](std::size_t n_contractions) {
      progress(n_contractions);
      return true;
    });
    decimater.set_observer(&observer);
    decimater.initialize();
    decimater.decimate_to_faces(target.n_vertices().value_or(0), target.n_faces().value_or(0));
  }
  mesh.garbage_collection();
  run.seconds_decimate = decimating.seconds();
  run.mesh = geometry_of(mesh);
  return run;
}

}  // namespace whittle::app
