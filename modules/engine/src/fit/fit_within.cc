#include "fit/fit_within.hh"

#include <utility>
#include <vector>

#include "error/marked_vertices.hh"

namespace whittle {
namespace {

constexpr int most_rounds = 4;

/// Holds vertices at violations and two rings around them: then few rounds are needed.
void hold_around(const std::vector<Index>& violations, const IndexedMesh& mesh, std::vector<std::uint8_t>& held) {
  const std::vector<std::uint8_t> at_violation = marked_vertices(violations, held.size());
  const std::vector<std::uint8_t> wide = with_neighbours(with_neighbours(at_violation, mesh.faces), mesh.faces);
  for (std::size_t v = 0; v < held.size(); ++v) held[v] |= wide[v];
}

}  // namespace

bool fit_within(ErrorBounds& bounds, const IndexedMesh& input, const detail::Fit& fit, Decimation& decimation) {
  const Frame frame = Frame::of_points(input.positions);
  std::vector<std::uint8_t> held(decimation.mesh.positions.size());
  for (int round = 0; round < most_rounds; ++round) {
    Decimation fitted = decimation;
    if (!fit(fitted, held)) return false;
    const ErrorBound::Violations violations = bounds.check({fitted.mesh, frame, fitted.vertex_map});
    if (violations.empty()) {
      decimation = std::move(fitted);
      return true;
    }
    hold_around(violations.vertices, fitted.mesh, held);
  }
  return false;
}

}  // namespace whittle
