#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "certify/arguments.hh"
#include "certify/recorded.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/proof/border_edges.hh"
#include "whittle/metrics/certify.hh"

namespace whittle::metrics {
namespace {

constexpr double infinitely_far = std::numeric_limits<double>::infinity();

/// The borders of two meshes, checked.
struct Borders {
  BorderEdges first;
  BorderEdges second;

  Borders(const IndexedMesh& a, const IndexedMesh& b) {
    bounds_of(a);
    bounds_of(b);
    first = border_edges_of(a);
    second = border_edges_of(b);
  }

  bool has_first() const { return !first.faces.empty(); }
  bool has_second() const { return !second.faces.empty(); }
  bool has_any() const { return has_first() || has_second(); }
  bool has_both() const { return has_first() && has_second(); }

  /// Replaces the edge's number by its face's.
  void name_face(FarPoint& point) const {
    if (point.face != invalid_index) point.face = (point.is_on_first ? first : second).faces[point.face];
  }
  /// A point of borders where the other mesh has none.
  FarPoint lost_point() const {
    const BorderEdges& border = has_first() ? first : second;
    return {has_first(), border.faces[0], border.mesh.positions[border.mesh.faces[0][0]], infinitely_far};
  }
};

LargestDistance one_way(const std::optional<FarPoint>& lost) {
  if (!lost) return {};
  return {infinitely_far, infinitely_far, *lost, 0};
}

}  // namespace

Certification certify_borders(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                              const CertifyOptions& options) {
  return certify_borders(first, second, max_distance, options, nullptr);
}

Certification certify_borders(const IndexedMesh& first, const IndexedMesh& second, double max_distance,
                              const CertifyOptions& options, std::string* sections) {
  require_distance(max_distance);
  if (!options.tolerances.empty()) {
    throw std::invalid_argument("certify_borders: there are tolerances, which are of the surface");
  }
  const Borders borders(first, second);
  if (!borders.has_any()) return {Verdict::proven, {}};
  if (!borders.has_both()) return {Verdict::refuted, borders.lost_point()};
  Certification result = certify(borders.first.mesh, borders.second.mesh, max_distance, options, sections);
  if (result.farther) borders.name_face(*result.farther);
  return result;
}

std::optional<LargestDistances> largest_border_distances(const IndexedMesh& first, const IndexedMesh& second,
                                                         double relative_accuracy,
                                                         const LargestDistanceOptions& options) {
  require_accuracy(relative_accuracy);
  const Borders borders(first, second);
  if (!borders.has_any()) return std::nullopt;
  if (!borders.has_both()) {
    const FarPoint lost = borders.lost_point();
    return LargestDistances{one_way(lost.is_on_first ? std::optional(lost) : std::nullopt),
                            one_way(lost.is_on_first ? std::nullopt : std::optional(lost))};
  }
  LargestDistances result = largest_distances(borders.first.mesh, borders.second.mesh, relative_accuracy, options);
  borders.name_face(result.forward.where);
  borders.name_face(result.backward.where);
  return result;
}

}  // namespace whittle::metrics
