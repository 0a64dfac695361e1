#include "bench/peers/cgal_mesh.hh"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Polyhedral_envelope_filter.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "bench/max_error/contenders/contender.hh"

// CGAL's edge_collapse by Lindstrom–Turk with Polyhedral_envelope_filter, as in its own example: new faces are refused
// that leave the envelope of the input.

namespace whittle::bench {

IndexedMesh by_cgal_envelope(const IndexedMesh& input, double length) {
  namespace sms = CGAL::Surface_mesh_simplification;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CgalMesh<Kernel>;
  using Filter = sms::Polyhedral_envelope_filter<Kernel, sms::Bounded_normal_change_filter<>>;
  auto mesh = cgal_mesh_of<Kernel>(input);
  sms::edge_collapse(mesh, sms::Count_stop_predicate<Mesh>(0),
                     CGAL::parameters::get_cost(sms::LindstromTurk_cost<Mesh>())
                         .filter(Filter(length))
                         .get_placement(sms::LindstromTurk_placement<Mesh>()));
  mesh.collect_garbage();
  return arrays_of_cgal(mesh);
}

}  // namespace whittle::bench
