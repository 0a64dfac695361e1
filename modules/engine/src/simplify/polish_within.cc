#include "simplify/polish_within.hh"

namespace whittle {
namespace {

constexpr int most_rounds = 4;

/// Adds the neighbours of the vertices that are marked.
std::vector<std::uint8_t> with_neighbours(const std::vector<std::uint8_t>& marked, const IndexedMesh& mesh) {
  std::vector<std::uint8_t> wider = marked;
  for (const auto& [a, b, c] : mesh.faces) {
    if ((marked[a] | marked[b] | marked[c]) != 0) wider[a] = wider[b] = wider[c] = 1;
  }
  return wider;
}

/// Holds vertices at violations and two rings around them: then few rounds are needed.
void hold_around(const std::vector<Index>& violations, const IndexedMesh& mesh, std::vector<std::uint8_t>& held) {
  std::vector<std::uint8_t> at_violation(held.size());
  for (const Index v : violations) at_violation[v] = 1;
  const std::vector<std::uint8_t> wide = with_neighbours(with_neighbours(at_violation, mesh), mesh);
  for (std::size_t v = 0; v < held.size(); ++v) held[v] |= wide[v];
}

}  // namespace

PolishResult polish_within(ErrorBounds& bounds, const IndexedMesh& input, Decimation& decimation,
                           const PolishHeld& polish) {
  const Frame frame = Frame::of_points(input.positions);
  std::vector<std::uint8_t> held(decimation.mesh.positions.size());
  for (int round = 0; round < most_rounds; ++round) {
    Decimation polished = decimation;
    const PolishResult result = polish(polished, held);
    if (result.cancelled) return result;
    const ErrorBound::Violations violations = bounds.check({polished.mesh, frame, polished.vertex_map});
    if (violations.empty()) {
      decimation = std::move(polished);
      return result;
    }
    hold_around(violations.vertices, polished.mesh, held);
  }
  return {};
}

}  // namespace whittle
