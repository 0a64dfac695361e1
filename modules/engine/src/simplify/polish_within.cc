#include "simplify/polish_within.hh"

namespace whittle {
namespace {

constexpr int most_rounds = 6;

/// Holds the vertices of faces that have a corner at a violation: then fewer rounds are needed.
void hold_around(const std::vector<std::uint8_t>& is_at_violation, const IndexedMesh& mesh,
                 std::vector<std::uint8_t>& held) {
  for (const auto& [a, b, c] : mesh.faces) {
    if ((is_at_violation[a] | is_at_violation[b] | is_at_violation[c]) == 0) continue;
    held[a] = held[b] = held[c] = 1;
  }
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
    const ErrorBound::Violations violations = bounds.check(polished.mesh, frame, polished.vertex_map);
    if (violations.empty()) {
      decimation = std::move(polished);
      return result;
    }
    std::vector<std::uint8_t> is_at_violation(held.size());
    for (const Index v : violations.vertices) is_at_violation[v] = 1;
    hold_around(is_at_violation, polished.mesh, held);
  }
  return {};
}

}  // namespace whittle
