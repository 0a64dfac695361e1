#include "whittle/polish/polish.hh"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "polisher.hh"
#include "surface/ordered_mesh.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/regions.hh"

namespace whittle {
namespace {

void check_edges(std::span<const VertexPair> edges, std::size_t n_vertices) {
  const auto is_known = [n_vertices](const VertexPair& edge) { return std::max(edge.a, edge.b) < n_vertices; };
  if (!std::all_of(edges.begin(), edges.end(), is_known)) {
    throw std::invalid_argument("polish: a feature edge or seam names a vertex that isn't there");
  }
}

void check_original(const IndexedMesh& original) {
  check_positions(original.positions, "polish");
  check_corners(original.positions.size(), original.faces);
}

/// \param n_original_vertices number of vertices of the original
void check(std::size_t n_original_vertices, std::span<const Index> vertex_map, const IndexedMesh& mesh,
           const PolishOptions& options) {
  check_positions(mesh.positions, "polish");
  check_corners(mesh.positions.size(), mesh.faces);
  check_attributes(mesh, "polish");
  if (vertex_map.size() != n_original_vertices) {
    throw std::invalid_argument("polish: vertex_map has another length than the original's vertices");
  }
  for (const Index v : vertex_map) {
    if (v == invalid_index || v < mesh.positions.size()) continue;
    throw std::invalid_argument("polish: vertex_map names vertex " + std::to_string(v) + " of " +
                                std::to_string(mesh.positions.size()));
  }
  if (!options.locked.empty() && options.locked.size() != mesh.positions.size()) {
    throw std::invalid_argument("polish: locked has another length than the vertices");
  }
  if (!options.regions.empty() && options.regions.size() != mesh.faces.size()) {
    throw std::invalid_argument("polish: regions has another length than the faces");
  }
  check_edges(options.features, mesh.positions.size());
  check_edges(options.original_features, n_original_vertices);
  check_edges(options.seams, mesh.positions.size());
  check_edges(options.original_seams, n_original_vertices);
  if (const auto weight = options.seam_weight; weight && !(*weight > 0 && std::isfinite(*weight))) {
    throw std::invalid_argument("polish: seam_weight is not in (0, inf)");
  }
  if (!(options.shape_weight >= 0 && std::isfinite(options.shape_weight))) {
    throw std::invalid_argument("polish: shape_weight is not in [0, inf)");
  }
  if (!(options.feature_tolerance >= 0)) {
    throw std::invalid_argument("polish: feature_tolerance is negative or not a number");
  }
  if (const auto angle = options.feature_angle_deg; angle && !(*angle > 0 && *angle < 180)) {
    throw std::invalid_argument("polish: feature_angle_deg is not in (0, 180)");
  }
  if (!(options.crease_angle_deg > 0 && options.crease_angle_deg <= 180)) {
    throw std::invalid_argument("polish: crease_angle_deg is not in (0, 180]");
  }
  if (const auto ratio = options.min_radius_ratio; ratio && !(*ratio >= 0 && *ratio <= 1)) {
    throw std::invalid_argument("polish: min_radius_ratio is not in [0, 1]");
  }
}

/// Whether a mesh lies near enough to the original, whose frame has about size 1, to be made from it.
bool is_near(const IndexedMesh& mesh, const Frame& frame) {
  constexpr double far = 1e6;
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [&](const Vec3& p) { return frame.to_frame(p).cwiseAbs().maxCoeff() <= far; });
}

PolishResult run(const polishing::OriginalSurface& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                 const PolishOptions& options) {
  PolishResult result;
  detail::ProgressMeter meter(options.progress);
  std::optional<polishing::Polisher> polisher;
  try {
    meter.start("preparing", polishing::run_fraction(0, options));
    polisher.emplace(original, vertex_map, mesh, options, meter);
    result.rms_before = polisher->rms();
    while (result.n_passes < options.passes && polisher->pass()) ++result.n_passes;
    meter.finish();
  } catch (const Cancelled&) {
    result.cancelled = true;
  }
  if (!polisher) return result;
  result.rms_after = polisher->rms();
  if (result.n_passes > 0) result.n_moved = polisher->write(mesh);
  return result;
}

}  // namespace

PolishOriginal::PolishOriginal(const IndexedMesh& mesh, unsigned threads, const ProgressCallback& progress) {
  check_original(mesh);
  detail::ProgressMeter meter(progress);
  meter.start("preparing", 0);
  surface_ = std::make_unique<const polishing::OriginalSurface>(mesh, detail::Workers(threads, &meter));
}

PolishOriginal::~PolishOriginal() = default;
PolishOriginal::PolishOriginal(PolishOriginal&&) noexcept = default;
PolishOriginal& PolishOriginal::operator=(PolishOriginal&&) noexcept = default;

PolishResult polish(const PolishOriginal& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options) {
  const polishing::OriginalSurface& surface = original.surface();
  const Frame& frame = surface.frame();
  check(surface.positions().size(), vertex_map, mesh, options);
  if (options.passes == 0 || mesh.faces.empty() || surface.faces().empty() || !is_near(mesh, frame)) return {};
  polishing::OrderedMesh ordered(mesh, frame, options.threads);
  PolishOptions ordered_options = options;
  ordered_options.locked = ordered.per_vertex(options.locked);
  ordered_options.features = ordered.map(options.features);
  ordered_options.seams = ordered.map(options.seams);
  ordered_options.flips = options.flips && mesh.wedges.empty();
  if (ordered_options.flips) {
    ordered_options.regions = ordered.per_face(options.regions.empty() ? face_regions(mesh) : options.regions);
  }
  const PolishResult result = run(surface, ordered.map(vertex_map), ordered.mesh, ordered_options);
  if (result.n_passes == 0) return result;
  ordered.write_to(mesh);
  if (options.recompute_normals && !mesh.normals.empty()) {
    recompute_normals(mesh, frame, options.crease_angle_deg);
  }
  return result;
}

PolishResult polish(const IndexedMesh& original, std::span<const Index> vertex_map, IndexedMesh& mesh,
                    const PolishOptions& options) {
  check_original(original);
  check(original.positions.size(), vertex_map, mesh, options);
  if (options.passes == 0 || mesh.faces.empty()) return {};
  try {
    return polish(PolishOriginal(original, options.threads, options.progress), vertex_map, mesh, options);
  } catch (const Cancelled&) {
    PolishResult result;
    result.cancelled = true;
    return result;
  }
}

}  // namespace whittle
