#include "guard/drifted_vertices.hh"

#include <algorithm>

namespace whittle::polishing {

std::vector<Index> take_back_drifted_vertices(const BackwardOffsets& before, double most, std::vector<Vec3>& positions,
                                              const detail::Workers& workers) {
  const std::vector<Vec3> now = before.after_moves(positions, most, workers);
  std::vector<Index> taken_back;
  for (Index v = 0; v < positions.size(); ++v) {
    if (!(now[v].squaredNorm() > std::max(most * most, before.offsets()[v].squaredNorm()))) continue;
    positions[v] = before.positions()[v];
    taken_back.push_back(v);
  }
  return taken_back;
}

}  // namespace whittle::polishing
