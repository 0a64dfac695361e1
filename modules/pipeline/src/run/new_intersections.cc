#include "whittle/pipeline/new_intersections.hh"

#include <cstddef>

#include "whittle/metrics/crossing_walls.hh"
#include "whittle/metrics/meeting_parts.hh"

namespace whittle {
namespace {

std::string text_of(std::size_t n, const std::string& one, const std::string& many) {
  if (n == 0) return {};
  return std::to_string(n) + " " + (n == 1 ? one : many) + " that didn't before";
}

}  // namespace

NewIntersections find_new_intersections(const IndexedMesh& before, const Decimation& result, unsigned threads) {
  if (result.mesh.faces.empty()) return {};
  return {text_of(metrics::newly_meeting_parts(before, result.mesh, result.vertex_map, threads).size(),
                  "pair of parts intersects", "pairs of parts intersect"),
          text_of(metrics::newly_crossing_faces(before, result.mesh, result.vertex_map, threads).size(),
                  "pair of faces of one part crosses", "pairs of faces of one part cross")};
}

}  // namespace whittle
