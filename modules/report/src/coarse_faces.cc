#include "whittle/core/wedges.hh"
#include "whittle/engine/simplify.hh"
#include "whittle/report/page.hh"

namespace whittle::report {

std::vector<Triangle> coarse_faces(const IndexedMesh& mesh, unsigned threads) {
  constexpr std::size_t n_coarse = 10'000;
  if (mesh.faces.size() < 3 * n_coarse) return {};
  const DecimateTarget target = DecimateTarget::faces(n_coarse);
  SimplifyOptions options;
  options.decimate.threads = threads;
  const IndexedMesh surface = without_attributes(mesh);
  std::vector<Triangle> faces =
      decimate_index_only(surface, target, with_effort(Effort::fast, options, surface, target).decimate).faces;
  if (faces.size() > mesh.faces.size() / 2) faces.clear();
  return faces;
}

}  // namespace whittle::report
