#include "packed_surface.hh"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "whittle/core/detail/edge_table.hh"

namespace whittle::report {
namespace {

constexpr double most_steps = 65535;

using PackedPosition = std::array<std::uint16_t, 4>;  ///< x, y, z, 0
using PackedEdge = std::array<Index, 2>;

std::uint16_t rounded(double steps) {
  return static_cast<std::uint16_t>(std::clamp(std::round(steps), 0.0, most_steps));
}

/// Bytes in groups of four.
using Bytes = std::vector<std::array<std::uint8_t, 4>>;

class ByteGroups {
 public:
  void add(std::uint8_t byte) {
    if (n_++ % 4 == 0) groups_.emplace_back();
    groups_.back()[(n_ - 1) % 4] = byte;
  }
  const Bytes& groups() const { return groups_; }

 private:
  Bytes groups_;
  std::size_t n_ = 0;
};

/// 0, 1, 2, … 127 for signed distances of 0 and above: in even steps up to the usual distance, then in even factors up
/// to the greatest one. Those below 0 have 128 more.
std::uint8_t packed_distance(double signed_distance, const DistanceMap& map) {
  constexpr double n_usual = 100;
  constexpr double n_greater = 27;
  const double distance = std::abs(signed_distance);
  double step = 0;
  if (distance <= map.usual) {
    step = map.usual > 0 ? distance / map.usual * n_usual : 0;
  } else {
    step = n_usual + std::ceil(n_greater * std::log(distance / map.usual) / std::log(map.max / map.usual));
  }
  return static_cast<std::uint8_t>(std::lround(std::min(step, n_usual + n_greater)) + (signed_distance < 0 ? 128 : 0));
}

Json pack(const DistanceMap& map, PageBytes& bytes) {
  ByteGroups values;
  for (const double distance : map.signed_distances) values.add(packed_distance(distance, map));
  ByteGroups cuts;
  Json rounds = Json::array();
  for (const std::vector<std::uint8_t>& round : map.rounds) {
    rounds.push_back(round.size());
    for (const std::uint8_t cut : round) cuts.add(cut);
  }
  return {{"max", map.max},
          {"usual", map.usual},
          {"vertices", map.signed_distances.size()},
          {"values", bytes.add(values.groups())},
          {"faces", map.mesh.faces.size()},
          {"rounds", std::move(rounds)},
          {"cuts", bytes.add(cuts.groups())}};
}

}  // namespace

Grid Grid::around(const metrics::Bounds& bounds) {
  const double longest = (bounds.max - bounds.min).maxCoeff();
  return {bounds.min, longest > 0 ? longest / most_steps : 1.0};
}

std::array<std::uint16_t, 3> Grid::at(const Vec3& position) const {
  const Vec3 steps = (position - origin) / step;
  return {rounded(steps.x()), rounded(steps.y()), rounded(steps.z())};
}

Json pack(const PageSurface& surface, const Grid& grid, PageBytes& bytes) {
  const IndexedMesh& mesh = surface.mesh;
  std::vector<PackedPosition> positions;
  for (const Vec3& position : mesh.positions) {
    const auto [x, y, z] = grid.at(position);
    positions.push_back({x, y, z, 0});
  }
  std::vector<PackedEdge> borders;
  std::vector<PackedEdge> nonmanifold;
  const detail::EdgeTable edges(mesh.faces, positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::size_t n = edges.sides(e).size();
    if (n != 2) (n == 1 ? borders : nonmanifold).push_back({edges[e].a, edges[e].b});
  }
  Json refusals = Json::array();
  for (const auto& [reason, pairs] : surface.refusals)
    refusals.push_back({{"reason", reason}, {"pairs", bytes.add(pairs)}});
  return {{"name", surface.name},
          {"note", surface.note},
          {"refusals", std::move(refusals)},
          {"vertices", positions.size()},
          {"faces", mesh.faces.size()},
          {"positions", bytes.add(positions)},
          {"corners", bytes.add_faces(mesh.faces, positions.size())},
          {"coarse", bytes.add_faces(surface.coarse_faces, positions.size())},
          {"borders", bytes.add(borders)},
          {"nonmanifold", bytes.add(nonmanifold)},
          {"distances", surface.distances ? pack(*surface.distances, bytes) : Json(nullptr)}};
}

}  // namespace whittle::report
