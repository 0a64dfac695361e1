#include "packed_surface.hh"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "packed_values.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/geometry/box.hh"
#include "whittle/core/wedges.hh"

namespace whittle::report {
namespace {

constexpr double most_steps = 65535;

using PackedPosition = std::array<std::uint16_t, 4>;  ///< x, y, z, 0
using PackedEdge = std::array<Index, 2>;

std::uint16_t rounded(double steps) {
  return static_cast<std::uint16_t>(std::clamp(std::round(steps), 0.0, most_steps));
}

Json pack(const DistanceMap& map, PageBytes& bytes) {
  ByteGroups values;
  for (const double distance : map.signed_distances) values.add(packed_value(distance, {map.max, map.usual}));
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

/// Vertex numbers; wedge numbers where there are wedges, of which the page knows the vertices.
std::vector<Triangle> packed_corners(std::vector<Triangle> faces, const std::vector<Index>& wedges) {
  for (std::size_t corner = 0; corner < wedges.size(); ++corner) faces[corner / 3][corner % 3] = wedges[corner];
  return faces;
}

}  // namespace

Grid Grid::around(const Box& bounds) {
  const double longest = bounds.sizes().maxCoeff();
  return {bounds.min(), longest > 0 ? longest / most_steps : 1.0};
}

std::array<std::uint16_t, 3> Grid::at(const Vec3& position) const {
  const Vec3 steps = (position - origin) / step;
  return {rounded(steps.x()), rounded(steps.y()), rounded(steps.z())};
}

Json pack(const PageSurface& surface, const Grid& grid, PageBytes& bytes, PageImages& images) {
  const IndexedMesh& mesh = surface.mesh;
  std::vector<PackedPosition> positions;
  for (const Vec3& position : mesh.positions) {
    const auto [x, y, z] = grid.at(position);
    positions.push_back({x, y, z, 0});
  }
  std::vector<PackedEdge> borders;
  std::vector<PackedEdge> nonmanifold;
  if (surface.marks_irregular_edges) {
    const detail::EdgeTable edges(mesh.faces, positions.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const std::size_t n = edges.sides(e).size();
      if (n != 2) (n == 1 ? borders : nonmanifold).push_back({edges[e].a, edges[e].b});
    }
  }
  Json refusals = Json::array();
  for (const auto& [reason, pairs] : surface.refusals)
    refusals.push_back({{"reason", reason}, {"pairs", bytes.add(pairs)}});
  Json look = pack_look(surface, bytes, images);
  const auto corners = [&](const auto& of) { return look.is_null() ? of.faces : packed_corners(of.faces, of.wedges); };
  const std::size_t n_corners = std::max(positions.size(), n_wedges(mesh));
  return {{"name", surface.name},
          {"note", surface.note},
          {"refusals", std::move(refusals)},
          {"vertices", positions.size()},
          {"faces", mesh.faces.size()},
          {"faces_of_file", std::max(mesh.faces.size(), surface.n_faces_of_file)},
          {"positions", bytes.add(positions)},
          {"corners", bytes.add_faces(corners(mesh), n_corners)},
          {"coarse", bytes.add_faces(corners(surface.coarse), n_corners)},
          {"borders", bytes.add(borders)},
          {"nonmanifold", bytes.add(nonmanifold)},
          {"error", surface.error ? Json{{"mean", surface.error->mean}, {"max", surface.error->max}} : Json(nullptr)},
          {"distances", surface.distances ? pack(*surface.distances, bytes) : Json(nullptr)},
          {"look", std::move(look)}};
}

}  // namespace whittle::report
