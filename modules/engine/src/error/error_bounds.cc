#include "error/error_bounds.hh"

#include <algorithm>

#include "whittle/core/geometry/proof/border_edges.hh"

namespace whittle {
namespace {

/// The mesh itself, or a copy of it without faces of which two corners are one.
const IndexedMesh& proper_faces(const IndexedMesh& mesh, IndexedMesh& copy) {
  if (std::all_of(mesh.faces.begin(), mesh.faces.end(), has_three_corners)) return mesh;
  copy.positions = mesh.positions;
  std::copy_if(mesh.faces.begin(), mesh.faces.end(), std::back_inserter(copy.faces), has_three_corners);
  return copy;
}

/// `map` for vertices that are ends of segments, `invalid_index` for others.
std::vector<Index> of_ends(std::span<const Index> map, const IndexedMesh& segments) {
  std::vector<Index> result(map.size(), invalid_index);
  for (const Triangle& segment : segments.faces) {
    for (const Index v : segment) result[v] = map[v];
  }
  return result;
}

}  // namespace

ErrorBounds::ErrorBounds(const IndexedMesh& input, const Frame& frame, double limit, double border_limit,
                         unsigned threads, std::span<const double> tolerances)
    : border_edges_(border_edges_of(input).mesh),
      surface_(std::make_unique<ErrorBound>(proper_faces(input, proper_), frame, limit, threads, tolerances)) {
  if (!border_edges_.faces.empty()) {
    borders_ = std::make_unique<ErrorBound>(border_edges_, frame, border_limit, threads);
  }
}

ErrorBound::Violations ErrorBounds::check(const CheckedSurface& surface) {
  ErrorBound::Violations violations = surface_->check(surface, surface_->limit());
  violations.add(check_borders(surface));
  return violations;
}

ErrorBound::Violations ErrorBounds::check_again(const CheckedSurface& surface,
                                                std::span<const std::uint8_t> is_changed) {
  ErrorBound::Violations violations = surface_->check_again(surface, is_changed);
  violations.add(check_borders(surface));
  return violations;
}

bool ErrorBounds::are_kept_by(const CheckedSurface& surface) {
  return check_borders(surface).empty() && surface_->is_kept_by(surface);
}

bool ErrorBounds::have_far_point(const CheckedSurface& surface) {
  return surface_->has_far_point(surface) || !check_borders(surface).empty();
}

ErrorBound::Violations ErrorBounds::check_borders(const CheckedSurface& surface) {
  const IndexedMesh edges = border_edges_of(surface.mesh).mesh;
  if (borders_) {
    return borders_->check({edges, surface.frame, of_ends(surface.vertex_map, border_edges_)}, borders_->limit());
  }
  ErrorBound::Violations violations;
  violations.is_surface_far = !edges.faces.empty();  // the input has none
  for (const Triangle& edge : edges.faces) violations.vertices.insert(violations.vertices.end(), {edge[0], edge[1]});
  return violations;
}

}  // namespace whittle
