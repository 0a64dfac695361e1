#include "cost/fold_edges.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>

#include "whittle/core/detail/parallel.hh"

namespace whittle {
namespace {

/// Of 1 - the cosine between the ways into two faces that lie on each other. Their normals are opposite to within the
/// root of twice that, and so are their octants, which are wider.
constexpr double most_apart = 1e-6;

/// The octants that a vector lies in, or nearly: bit 4 z + 2 y + x, where a coordinate counts 1 if it isn't negative.
/// Those of a vector and its opposite are each other's mirror images.
std::uint8_t octants_of(const Vec3& vector) {
  const double nearly_zero = 2e-3 * vector.cwiseAbs().maxCoeff();
  // Without branches, as no processor foresees signs.
  const auto half = [&](double x, unsigned not_negative) {
    const unsigned is_positive = x > nearly_zero ? 1 : 0;
    const unsigned is_negative = x < -nearly_zero ? 1 : 0;
    return (not_negative & (0U - (1U - is_negative))) | (~not_negative & (0U - (1U - is_positive)));
  };
  return static_cast<std::uint8_t>(half(vector.x(), 0b10101010) & half(vector.y(), 0b11001100) &
                                   half(vector.z(), 0b11110000));
}

bool has_opposite_octants(unsigned octants) {
  for (unsigned octant = 0; octant < 4; ++octant) {
    if (((octants >> octant) & (octants >> (7 - octant)) & 1U) != 0) return true;
  }
  return false;
}

/// Vertices with faces whose normals may be opposite. Most meshes have few.
std::vector<std::uint8_t> vertices_that_may_lie_on_rims(const IndexedMesh& mesh, const Frame& frame, unsigned threads) {
  std::vector<std::uint8_t> octants(mesh.positions.size());
  for_each_range(mesh.faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = mesh.faces[f];
      const Vec3 edge = (mesh.positions[b] - mesh.positions[a]) * frame.scale;
      const Vec3 other = (mesh.positions[c] - mesh.positions[a]) * frame.scale;
      const std::uint8_t of_face = octants_of(edge.cross(other));
      for (const Index v : mesh.faces[f]) {
        const std::atomic_ref at_vertex(octants[v]);
        if ((of_face & ~at_vertex.load(std::memory_order_relaxed)) == 0) continue;
        at_vertex.fetch_or(of_face, std::memory_order_relaxed);
      }
    }
  });
  for (std::uint8_t& of_vertex : octants) of_vertex = has_opposite_octants(of_vertex) ? 1 : 0;
  return octants;
}

/// A face at an edge.
struct Side {
  VertexPair edge;
  Index face;
  bool is_forward;  ///< from the lower end to the higher one
};

/// The sides of edges whose ends are both marked, by edge.
std::vector<Side> sides_between(const IndexedMesh& mesh, const std::vector<std::uint8_t>& marked) {
  std::vector<Side> sides;
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const Triangle& face = mesh.faces[f];
    if (!has_three_corners(face)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = face[k];
      const Index to = face[(k + 1) % 3];
      if (marked[from] != 0 && marked[to] != 0)
        sides.push_back({{std::min(from, to), std::max(from, to)}, f, from < to});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) { return s.edge < t.edge; });
  return sides;
}

/// From an edge into a face, perpendicular to the edge.
Vec3 inward(const IndexedMesh& mesh, const Frame& frame, const Side& side) {
  const auto& [a, b] = side.edge;
  const Triangle& face = mesh.faces[side.face];
  const auto third = std::find_if(face.begin(), face.end(), [a = a, b = b](Index v) { return v != a && v != b; });
  const Vec3 along = ((mesh.positions[b] - mesh.positions[a]) * frame.scale).stableNormalized();
  const Vec3 way = (mesh.positions[*third] - mesh.positions[a]) * frame.scale;
  return way - along.dot(way) * along;
}

bool lie_on_each_other(const IndexedMesh& mesh, const Frame& frame, const Side& side, const Side& other) {
  if (side.is_forward == other.is_forward) return false;
  const Vec3 way = inward(mesh, frame, side);
  const Vec3 other_way = inward(mesh, frame, other);
  const double lengths = way.norm() * other_way.norm();
  return lengths > 0 && way.dot(other_way) > (1 - most_apart) * lengths;
}

}  // namespace

std::vector<VertexPair> fold_edges(const IndexedMesh& mesh, const Frame& frame, unsigned threads) {
  const std::vector<std::uint8_t> may_lie_on_rims = vertices_that_may_lie_on_rims(mesh, frame, threads);
  if (std::find(may_lie_on_rims.begin(), may_lie_on_rims.end(), 1) == may_lie_on_rims.end()) return {};
  const std::vector<Side> sides = sides_between(mesh, may_lie_on_rims);
  std::vector<VertexPair> folds;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::find_if(begin, sides.end(), [&](const Side& side) { return side.edge != begin->edge; });
    if (end - begin == 2 && lie_on_each_other(mesh, frame, begin[0], begin[1])) folds.push_back(begin->edge);
    begin = end;
  }
  return folds;
}

}  // namespace whittle
