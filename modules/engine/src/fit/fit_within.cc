#include "fit/fit_within.hh"

#include <algorithm>
#include <utility>
#include <vector>

#include "error/marked_vertices.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle {
namespace {

/// How far vertices go towards where a fit puts them.
class PartOfTheWay {
 public:
  PartOfTheWay(std::vector<Vec3> from, std::vector<Vec3> to)
      : from_(std::move(from)), to_(std::move(to)), shares_(from_.size(), 1) {}

  /// Lets vertices go a third of the way, or nowhere if that was it.
  /// \return a vertex, 1 if it goes less far now
  std::vector<std::uint8_t> shorten(std::vector<std::uint8_t> is_at_violation) {
    for (std::size_t v = 0; v < shares_.size(); ++v) {
      if (shares_[v] == 0) is_at_violation[v] = 0;
      if (is_at_violation[v] != 0) shares_[v] = shares_[v] == 1 ? third : 0;
    }
    return is_at_violation;
  }

  /// Adds the corners of faces that turn by more than a right angle.
  void add_turned(const IndexedMesh& mesh, std::vector<Index>& vertices) const {
    for (const Triangle& face : mesh.faces) {
      if (area_normal(from_, face).dot(area_normal(mesh.positions, face)) >= 0) continue;
      vertices.insert(vertices.end(), face.begin(), face.end());
    }
  }

  void place(std::vector<Vec3>& positions) const {
    for (std::size_t v = 0; v < shares_.size(); ++v) {
      positions[v] = shares_[v] == 1 ? to_[v] : from_[v] + shares_[v] * (to_[v] - from_[v]);
    }
  }

 private:
  static constexpr double third = 1.0 / 3;

  std::vector<Vec3> from_, to_;
  std::vector<double> shares_;
};

bool is_any(const std::vector<std::uint8_t>& marked) {
  return std::any_of(marked.begin(), marked.end(), [](std::uint8_t is_marked) { return is_marked != 0; });
}

}  // namespace

bool fit_within(ErrorBounds& bounds, const IndexedMesh& input, const detail::Fit& fit, Decimation& decimation) {
  const Frame frame = Frame::of_points(input.positions);
  Decimation fitted = decimation;
  if (!fit(fitted)) return false;
  constexpr double far = 0.9;  // of the limit: beside such vertices the proof mostly fails
  PartOfTheWay way(decimation.mesh.positions, fitted.mesh.positions);
  way.shorten(bounds.surface().far_vertices({fitted.mesh, frame, fitted.vertex_map}, far));
  way.place(fitted.mesh.positions);
  const CheckedSurface surface{fitted.mesh, frame, fitted.vertex_map};
  ErrorBound::Violations violations = bounds.check(surface);
  way.add_turned(fitted.mesh, violations.vertices);
  while (!violations.empty() || !violations.vertices.empty()) {
    const std::vector<std::uint8_t> at_violation = marked_vertices(violations.vertices, fitted.mesh.positions.size());
    std::vector<std::uint8_t> is_changed = way.shorten(at_violation);
    if (!is_any(is_changed)) is_changed = way.shorten(with_neighbours(at_violation, fitted.mesh.faces));
    if (!is_any(is_changed)) return false;
    way.place(fitted.mesh.positions);
    violations = bounds.check_again(surface, is_changed);
    way.add_turned(fitted.mesh, violations.vertices);
  }
  if (fitted.mesh.positions == decimation.mesh.positions) return false;
  decimation = std::move(fitted);
  return true;
}

}  // namespace whittle
