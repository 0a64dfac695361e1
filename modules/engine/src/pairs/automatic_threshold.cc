#include "whittle/engine/automatic_threshold.hh"

#include <algorithm>

#include "whittle/core/detail/checks.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/engine/part_gaps.hh"

namespace whittle {
namespace {

constexpr double near_share = 0.05;           ///< of the mesh, the widest gap that counts
constexpr double margin = 1.1;                ///< more pairs than the nearest one join the parts over some width
constexpr double least_share_of_part = 1e-9;  ///< of the part, where gaps are zero, so that parts that touch are joined

}  // namespace

double automatic_threshold(const IndexedMesh& mesh, unsigned threads) {
  check_corners(mesh.positions.size(), mesh.faces);
  const Parts parts = find_parts(mesh.positions.size(), mesh.faces);
  if (parts.count < 2) return 0;
  const std::vector<double> diagonals = part_diagonals(mesh.positions, parts);
  const std::vector<double> gaps = gaps_between_parts(mesh, parts, {near_share * diagonal_of(mesh.positions), threads});
  double threshold = 0;
  for (std::size_t part = 0; part < parts.count; ++part) {
    if (gaps[part] > diagonals[part]) continue;
    threshold = std::max({threshold, margin * gaps[part], least_share_of_part * diagonals[part]});
  }
  return threshold;
}

}  // namespace whittle
