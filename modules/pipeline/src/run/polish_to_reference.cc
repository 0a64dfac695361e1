#include "whittle/pipeline/polish_to_reference.hh"

#include "whittle/core/wedges.hh"
#include "whittle/metrics/nearest_vertices.hh"

namespace whittle {
namespace {

PolishOptions polish_options(const IndexedMesh& reference, const IndexedMesh& mesh, const PolishRequest& request) {
  PolishOptions options{.passes = request.passes, .fit = request.fit, .locked = request.locked};
  options.threads = request.threads;
  options.seams = seam_edges(mesh);
  options.original_seams = seam_edges(reference);
  // A vertex keeps as many normals as it has.
  options.recompute_normals = mesh.wedges.empty();
  options.crease_angle_deg = 180;
  return options;
}

}  // namespace

PolishResult polish_to_reference(const IndexedMesh& reference, IndexedMesh& mesh, const PolishRequest& request) {
  // On large meshes the search takes about as long as one pass.
  const double search = 1.0 / (1 + request.passes);
  const std::vector<Index> nearest =
      metrics::nearest_vertices(reference, mesh, request.threads, part_of(request.progress, 0, search));
  PolishOptions options = polish_options(reference, mesh, request);
  options.progress = part_of(request.progress, search, 1);
  return polish(reference, nearest, mesh, options);
}

}  // namespace whittle
