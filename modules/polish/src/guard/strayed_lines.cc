#include "guard/strayed_lines.hh"

#include <algorithm>

namespace whittle::polishing {

std::vector<Index> take_back_strayed_lines(const Surface& before, const MeshLines& lines, LineSamples& samples,
                                           std::vector<Vec3>& positions, const detail::Workers& workers) {
  if (lines.empty()) return {};
  constexpr double rounding = 1e-9;
  const std::vector<double> distances = samples.distances(lines, before.positions);
  const double most = (1 + rounding) * *std::max_element(distances.begin(), distances.end());
  std::vector<Index> taken_back;
  for (bool is_done = false; !is_done;) {
    is_done = true;
    samples.find_feet(lines, {before.faces, before.corners, positions}, workers);
    const std::vector<double> now = samples.distances(lines, positions);
    for (Index v = 0; v < now.size(); ++v) {
      if (!(now[v] > most) || positions[v] == before.positions[v]) continue;
      positions[v] = before.positions[v];
      taken_back.push_back(v);
      is_done = false;
    }
  }
  return taken_back;
}

}  // namespace whittle::polishing
