#include "whittle/engine/detail/decimate_and_fit.hh"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "decimate/checkpoint/changes.hh"
#include "decimate/run.hh"
#include "fit/fit_within.hh"

namespace whittle::detail {
namespace {

/// The vertices of the input that those of the result stand for, ascending.
std::vector<Index> vertices_left(const Decimation& decimation) {
  std::vector<std::uint8_t> is_removed(decimation.vertex_map.size());
  for (const Contraction& contraction : decimation.steps.contractions) is_removed[contraction.removed] = 1;
  std::vector<Index> vertices;
  for (Index v = 0; v < is_removed.size(); ++v) {
    if (is_removed[v] == 0 && decimation.vertex_map[v] != invalid_index) vertices.push_back(v);
  }
  return vertices;
}

/// \param earlier, later ascending
std::vector<PassEnd::MovedVertex> merged_moves(std::vector<PassEnd::MovedVertex> earlier,
                                               const std::vector<PassEnd::MovedVertex>& later) {
  const auto is_before = [](const PassEnd::MovedVertex& a, const PassEnd::MovedVertex& b) {
    return a.vertex < b.vertex;
  };
  std::erase_if(earlier, [&](const PassEnd::MovedVertex& moved) {
    return std::binary_search(later.begin(), later.end(), moved, is_before);
  });
  std::vector<PassEnd::MovedVertex> all;
  std::merge(earlier.begin(), earlier.end(), later.begin(), later.end(), std::back_inserter(all), is_before);
  return all;
}

/// Calls `fit`, and notes what it changes. \return what it returns
template <class FitAndTell>
bool fit_and_note(Decimation& decimation, const FitAndTell& fit) {
  if (decimation.steps.pass_ends.empty()) return fit();
  const std::vector<Vec3> positions = decimation.mesh.positions;
  const std::vector<Triangle> faces = decimation.mesh.faces;
  const bool result = fit();
  const std::vector<Index> vertices = vertices_left(decimation);
  PassEnd& end = decimation.steps.pass_ends.back();
  end.moved = merged_moves(std::move(end.moved), moved_vertices(positions, decimation.mesh.positions, vertices));
  end.turned = turned_faces(faces, decimation.mesh.faces, vertices, decimation.face_origins);
  return result;
}

}  // namespace

FittedDecimation decimate_and_fit(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                                  const Fit& fit) {
  std::unique_ptr<ErrorBounds> bounds;  // none if there is nothing to prove
  FittedDecimation result{run(mesh, target, options, nullptr, {}, &bounds, !fit)};
  Decimation& decimation = result.decimation;
  if (!fit || decimation.result.stop == StopReason::cancelled) return result;
  result.is_fitted = fit_and_note(decimation, [&] {
    if (bounds) return fit_within(*bounds, mesh, fit, decimation);
    fit(decimation);
    return true;
  });
  return result;
}

}  // namespace whittle::detail
