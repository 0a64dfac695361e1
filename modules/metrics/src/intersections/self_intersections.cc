#include "whittle/metrics/self_intersections.hh"

#include "intersections/face_intersections.hh"

namespace whittle::metrics {

std::vector<std::array<Index, 2>> self_intersections(const IndexedMesh& mesh, unsigned threads,
                                                     const ProgressCallback& progress) {
  return face_intersections(mesh, {}, threads, progress);
}

}  // namespace whittle::metrics
