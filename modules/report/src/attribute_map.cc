#include "whittle/report/attribute_map.hh"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "whittle/core/geometry/triangle.hh"
#include "whittle/metrics/attribute_deviation.hh"

namespace whittle::report {
namespace {

/// Per wedge, the area of its faces.
std::vector<double> areas_of_wedges(const IndexedMesh& mesh, std::size_t n_wedges) {
  std::vector<double> areas(n_wedges);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) areas[mesh.wedge(f, k)] += area_of(mesh.positions, mesh.faces[f]);
  }
  return areas;
}

/// 99 % of the area has at most that.
double usual_of(const std::vector<double>& deviations, const std::vector<double>& areas) {
  constexpr double share = 0.99;
  std::vector<Index> order(deviations.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return std::pair(deviations[a], a) < std::pair(deviations[b], b); });
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  double so_far = 0;
  for (const Index w : order) {
    so_far += areas[w];
    if (so_far >= share * total) return deviations[w];
  }
  return deviations[order.back()];
}

}  // namespace

std::vector<AttributeMap> attribute_maps(const IndexedMesh& mesh, const IndexedMesh& other, unsigned threads) {
  constexpr std::array kinds{AttributeKind::texcoord, AttributeKind::color, AttributeKind::normal};
  std::vector<AttributeMap> maps;
  for (metrics::WedgeDeviations& found : metrics::attribute_deviations_at_wedges(mesh, other, kinds, threads)) {
    AttributeMap& map = maps.emplace_back();
    map.name = std::move(found.name);
    map.kind = found.kind;
    map.deviations = std::move(found.values);
    map.max = *std::max_element(map.deviations.begin(), map.deviations.end());
    map.usual = usual_of(map.deviations, areas_of_wedges(mesh, map.deviations.size()));
  }
  return maps;
}

}  // namespace whittle::report
