// A limit of how far a contraction of a round may move the surface, against its definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "support/shapes/shapes.hh"
#include "unit/engine/rounds/in_rounds.hh"
#include "whittle/core/geometry/proof/linked_faces.hh"

namespace whittle::test {
namespace {

/// The border edges of faces at a vertex, as triangles of which two corners are one.
std::vector<Corners> border_edges_at(Index v, const std::vector<Triangle>& faces, const std::vector<Vec3>& positions) {
  std::map<Index, int> n_named;
  for (const Triangle& face : faces) {
    if (std::find(face.begin(), face.end(), v) == face.end()) continue;
    for (const Index w : face) n_named[w] += w != v ? 1 : 0;
  }
  std::vector<Corners> edges;
  for (const auto& [w, n] : n_named) {
    if (n == 1) edges.push_back({positions[v], positions[w], positions[w]});
  }
  return edges;
}

double least_distance(const std::vector<Corners>& faces, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Corners& face : faces) least = std::min(least, distance_to(face, point));
  return least;
}

TEST(Rounds, MoveTheSurfaceNoFartherThanALimit) {
  for (const IndexedMesh& mesh : {blob(4, 3), terrain(32, 3), open_cylinder(40, 20)}) {
    std::mt19937 random(5);
    std::vector<double> limits(mesh.positions.size());
    for (double& limit : limits) limit = random() % 2 == 0 ? 0.002 : 0.01;
    const StageLimits stage_limits{.displacement = 0.01, .displacements = limits};
    InRounds in_rounds(mesh, {}, {}, {}, options_of_rounds(), stage_limits);
    in_rounds.rounds().run(std::numeric_limits<double>::infinity());
    EXPECT_GT(in_rounds.made().size(), mesh.positions.size() / 20);
    std::vector<Vec3> positions = mesh.positions;
    std::vector<Triangle> faces = mesh.faces;
    const auto star_of = [&](Index v, Index other) {
      std::vector<Corners> star;
      for (const Triangle& face : faces) {
        const bool is_at = std::any_of(face.begin(), face.end(), [&](Index w) { return w == v || w == other; });
        if (is_at) star.push_back(corners_of(positions, face));
      }
      return star;
    };
    for (const Contraction& made : in_rounds.made()) {
      const auto& [survivor, removed] = std::pair{made.survivor, made.removed};
      const double limit = (1 + 1e-9) * std::min(limits[survivor], limits[removed]);
      const std::vector<Corners> before = star_of(survivor, removed);
      std::vector<Corners> border_before = border_edges_at(survivor, faces, positions);
      for (const Corners& edge : border_edges_at(removed, faces, positions)) border_before.push_back(edge);
      const std::array<Vec3, 2> ends{positions[survivor], positions[removed]};
      const std::array<bool, 2> on_border{!border_edges_at(survivor, faces, positions).empty(),
                                          !border_edges_at(removed, faces, positions).empty()};
      limits[survivor] = std::min(limits[survivor], limits[removed]);
      positions[survivor] = made.position;
      for (Triangle& face : faces) std::replace(face.begin(), face.end(), removed, survivor);
      std::erase_if(faces, [](const Triangle& face) { return !has_three_corners(face); });
      const std::vector<Corners> after = star_of(survivor, survivor);
      const std::vector<Corners> border_after = border_edges_at(survivor, faces, positions);
      ASSERT_LE(least_distance(before, made.position), limit);
      for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_LE(least_distance(after, ends[i]), limit);
        const double to_border = on_border[i] ? least_distance(border_after, ends[i]) : 0;
        ASSERT_LE(to_border, limit);
      }
      const double from_border = border_after.empty() ? 0 : least_distance(border_before, made.position);
      ASSERT_LE(from_border, limit);
    }
  }
}

}  // namespace
}  // namespace whittle::test
