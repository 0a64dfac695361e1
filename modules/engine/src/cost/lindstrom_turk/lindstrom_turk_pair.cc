#include "whittle/engine/formula/lindstrom_turk_pair.hh"

#include <algorithm>
#include <vector>

#include "whittle/engine/formula/lindstrom_turk.hh"
#include "whittle/engine/formula/volume_sums.hh"

namespace whittle {

StarSums sum_star(const Vec3& position, std::span<const LinkEdgePoints> faces, std::span<const Vec3> neighbours) {
  const Double4 p = side_by_side(position);
  StarAdder star;
  for (const auto& [x, y] : faces) star.add_face(side_by_side(x) - p, side_by_side(y) - p);
  for (const Vec3& neighbour : neighbours) star.add_neighbour(side_by_side(neighbour) - p);
  return star.sums(p, neighbours.size());
}

PairEvaluation evaluate_lindstrom_turk(const StarSums& first, const StarSums& second,
                                       std::span<const CommonFace> common, std::span<const BorderEdge> border,
                                       PairConstraint constraint) {
  const auto star_first = [&](std::size_t) -> const StarSums& { return first; };
  const auto star_second = [&](std::size_t) -> const StarSums& { return second; };
  const StarLanes<double> a = star_lanes<double>(star_first);
  const StarLanes<double> b = star_lanes<double>(star_second);
  const PointLanes<double> d = b.position - a.position;
  const Vec3 origin(a.position.x, a.position.y, a.position.z);

  std::vector<CommonFaceLanes<double>> faces;
  std::vector<CommonFaceLanes<double>> corners;  // each once
  for (std::size_t i = 0; i < common.size(); ++i) {
    faces.push_back({point_lanes(common[i].position) - a.position, static_cast<double>(common[i].turn)});
    if (i == 0 || common[i].vertex != common[i - 1].vertex) corners.push_back(faces.back());
  }
  BorderSums border_sums;
  for (const auto& [from, to] : border) border_sums.add(from - origin, to - origin);

  LindstromTurk term(pair_volume(a, b, d, faces), border_sums, Vec3::Zero(), {d.x, d.y, d.z});
  if (!term.is_determined()) {
    const NeighbourLanes<double> of_a = neighbour_lanes<double>(star_first);
    const NeighbourLanes<double> of_b = neighbour_lanes<double>(star_second);
    term.add_neighbours(pair_neighbours(of_a, of_b, d, corners));
  }
  const Vec3 there(b.position.x, b.position.y, b.position.z);
  return in_frame(term.evaluate(constraint), origin, there);
}

}  // namespace whittle
