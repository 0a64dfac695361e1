#include "cost/cost_state.hh"

namespace whittle {

void CostState::move_origins(std::span<const Vec3> before, std::span<const Vec3> after) {
  for (std::vector<VertexQuadric>* const all : {&quadrics, &seams, &faces}) {
    for (auto& [v, quadric] : *all) {
      const Vec3 way = after[v] - before[v];
      if (!way.isZero(0)) quadric = quadric.about(way);
    }
  }
  for (Index w = 0; w < attributes.vertex_of.size(); ++w) {
    const Index v = attributes.vertex_of[w];
    const Vec3 way = after[v] - before[v];
    if (!way.isZero(0)) attributes.wedges.move_origin(w, way);
  }
}

}  // namespace whittle
