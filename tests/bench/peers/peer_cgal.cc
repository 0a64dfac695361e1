#include "bench/peers/cgal_mesh.hh"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "bench/peers/peer.hh"

// CGAL's Surface_mesh_simplification on Surface_mesh with coordinates in double: Lindstrom–Turk, its default, and
// Garland–Heckbert with planes and bounded normal change, as in its own example.

namespace whittle::bench {
namespace {

namespace sms = CGAL::Surface_mesh_simplification;
using Mesh = CgalMesh<>;

/// CGAL's own predicates count edges. A contraction on a border removes fewer edges than one inside.
struct StopAtFaces {
  std::size_t n_faces;
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const {
    return profile.surface_mesh().number_of_faces() <= n_faces;
  }
};

void by_lindstrom_turk(Mesh& mesh, std::size_t n_faces) {
  sms::edge_collapse(
      mesh, StopAtFaces{n_faces},
      CGAL::parameters::get_cost(sms::LindstromTurk_cost<Mesh>()).get_placement(sms::LindstromTurk_placement<Mesh>()));
}

void by_garland_heckbert(Mesh& mesh, std::size_t n_faces) {
  using Policies = sms::GarlandHeckbert_plane_policies<Mesh, CgalKernel>;
  const Policies policies(mesh);
  const sms::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
  sms::edge_collapse(mesh, StopAtFaces{n_faces},
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
}

class Cgal : public Peer {
 public:
  using Simplify = void (*)(Mesh&, std::size_t n_faces);
  explicit Cgal(Simplify simplify) : simplify_(simplify) {}

  IndexedMesh decimate(const IndexedMesh& input, std::size_t n_faces, Meter& meter) const override {
    Mesh mesh = cgal_mesh_of(input);
    meter.start();
    simplify_(mesh, n_faces);
    mesh.collect_garbage();
    meter.stop();
    return arrays_of_cgal(mesh);
  }

 private:
  Simplify simplify_;
};

}  // namespace

std::unique_ptr<Peer> make_cgal_lindstrom_turk() { return std::make_unique<Cgal>(by_lindstrom_turk); }
std::unique_ptr<Peer> make_cgal_garland_heckbert() { return std::make_unique<Cgal>(by_garland_heckbert); }

}  // namespace whittle::bench
