#include "bench/peers/cgal_mesh.hh"

#include <CGAL/Polygon_mesh_processing/distance.h>

#include "bench/max_error/cgal_distance.hh"

namespace whittle::bench {

double cgal_distance(const IndexedMesh& a, const IndexedMesh& b, double bound) {
  return CGAL::Polygon_mesh_processing::bounded_error_symmetric_Hausdorff_distance<CGAL::Sequential_tag>(
      cgal_mesh_of(a), cgal_mesh_of(b), bound);
}

}  // namespace whittle::bench
