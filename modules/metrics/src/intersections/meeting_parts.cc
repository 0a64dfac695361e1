#include "whittle/metrics/meeting_parts.hh"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "intersections/face_intersections.hh"
#include "intersections/vertex_map.hh"
#include "whittle/core/detail/drop.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/bounds.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/parts.hh"
#include "whittle/core/pieces.hh"
#include "working_scale.hh"

namespace whittle::metrics {
namespace {

using PartPairs = std::vector<std::array<Index, 2>>;

/// With more parts, all faces are compared: comparing all parts would take longer.
constexpr std::size_t most_parts_compared = 2000;

/// For each part a box around where its own box overlaps that of another.
std::vector<Box> overlaps(const std::vector<Box>& boxes) {
  std::vector<Index> order(boxes.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto begins_before = [&](Index p, Index q) { return boxes[p].min().x() < boxes[q].min().x(); };
  std::stable_sort(order.begin(), order.end(), begins_before);
  std::vector<Box> common(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Box& box = boxes[order[i]];
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].min().x() <= box.max().x(); ++j) {
      if (!box.intersects(boxes[order[j]])) continue;
      const Box both = box.intersection(boxes[order[j]]);
      common[order[i]].extend(both);
      common[order[j]].extend(both);
    }
  }
  return common;
}

/// Per face, whether it may intersect a face of another part. \param part_of per face, `invalid_index` for none
std::vector<char> faces_near_other_parts(const IndexedMesh& mesh, const std::vector<Index>& part_of,
                                         std::size_t n_parts) {
  std::vector<char> is_near(mesh.faces.size());
  for (std::size_t f = 0; f < is_near.size(); ++f) is_near[f] = part_of[f] != invalid_index;
  if (n_parts > most_parts_compared) return is_near;
  std::vector<Box> boxes(n_parts);
  for (std::size_t f = 0; f < is_near.size(); ++f) {
    if (is_near[f]) boxes[part_of[f]].extend(box_of(corners_of(mesh.positions, mesh.faces[f])));
  }
  const std::vector<Box> common = overlaps(boxes);
  for (std::size_t f = 0; f < is_near.size(); ++f) {
    is_near[f] = is_near[f] && common[part_of[f]].intersects(box_of(corners_of(mesh.positions, mesh.faces[f])));
  }
  return is_near;
}

/// Pairs of parts that intersect, ascending. \param part_of as above
PartPairs meeting_parts(const IndexedMesh& mesh, std::vector<Index> part_of, std::size_t n_parts, unsigned threads) {
  const std::vector<char> is_near = faces_near_other_parts(mesh, part_of, n_parts);
  IndexedMesh near;
  near.positions = mesh.positions;
  std::size_t n_near = 0;
  for (std::size_t f = 0; f < is_near.size(); ++f) {
    if (!is_near[f]) continue;
    near.faces.push_back(mesh.faces[f]);
    part_of[n_near++] = part_of[f];
  }
  if (near.faces.empty()) return {};
  std::vector<char> is_used(near.positions.size());
  for (const Triangle& face : near.faces) {
    for (const Index v : face) is_used[v] = 1;
  }
  drop_vertices(near, [&](std::size_t v) { return is_used[v] == 0; });
  const auto are_apart = [&](Index f, Index g) { return part_of[f] != part_of[g]; };
  PartPairs pairs;
  for (const auto& [f, g] : face_intersections(near, are_apart, threads, {})) {
    pairs.push_back({std::min(part_of[f], part_of[g]), std::max(part_of[f], part_of[g])});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// A part of a mesh, to be compared with others.
struct ComparedPart {
  IndexedMesh mesh;  ///< positions and faces
  std::optional<TriangleTree> tree;

  Corners corners(Index f) const { return corners_of(mesh.positions, mesh.faces[f]); }
};

/// Stops at the first intersection: most parts that are asked for have many.
bool do_meet(const ComparedPart& part, const ComparedPart& other) {
  const bool is_smaller = part.mesh.faces.size() <= other.mesh.faces.size();
  const ComparedPart& few = is_smaller ? part : other;
  const ComparedPart& many = is_smaller ? other : part;
  const Vec3& origin = many.tree->origin();
  bool is_found = false;
  for (Index f = 0; f < few.mesh.faces.size() && !is_found; ++f) {
    const Corners face = few.corners(f);
    if (!has_area(face)) continue;
    many.tree->visit_boxes(box_of(face).translated(-origin), [&](Index g) {
      const Corners near = many.corners(g);
      is_found = is_found || (has_area(near) && do_intersect(face, near));
    });
  }
  return is_found;
}

/// The intersecting pairs of some pairs of parts. \param part_of per face, `invalid_index` for none
PartPairs meeting_ones(const PartPairs& pairs, const IndexedMesh& mesh, const std::vector<Index>& part_of,
                       std::size_t n_parts, unsigned threads) {
  const Box box = bounds_of(mesh);
  if (const double scale = working_scale({box}); scale != 1.0) {
    return meeting_ones(pairs, metrics::scaled(mesh, scale), part_of, n_parts, threads);
  }
  IndexedMesh shape;
  shape.positions = mesh.positions;
  std::vector<Index> part_of_kept;
  for (std::size_t f = 0; f < part_of.size(); ++f) {
    if (part_of[f] == invalid_index) continue;
    shape.faces.push_back(mesh.faces[f]);
    part_of_kept.push_back(part_of[f]);
  }
  std::vector<MeshPiece> pieces = split_mesh(shape, part_of_kept, n_parts);
  std::vector<ComparedPart> parts(n_parts);
  for_each_block(n_parts, threads, [&](std::size_t p) {
    parts[p].mesh = std::move(pieces[p].mesh);
    if (!parts[p].mesh.faces.empty()) parts[p].tree.emplace(parts[p].mesh, center_of(box));
  });
  std::vector<char> meets(pairs.size());
  for_each_block(pairs.size(), threads, [&](std::size_t i) {
    const auto& [p, q] = pairs[i];
    meets[i] = parts[p].tree && parts[q].tree && do_meet(parts[p], parts[q]);
  });
  PartPairs meeting;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (meets[i]) meeting.push_back(pairs[i]);
  }
  return meeting;
}

/// The part that each face of the mesh before became one of; of parts in `pairs` alone.
std::vector<Index> parts_before(const IndexedMesh& before, std::span<const Index> vertex_map, const Parts& parts,
                                const PartPairs& pairs) {
  std::vector<char> is_asked(parts.count);
  for (const auto& [p, q] : pairs) is_asked[p] = is_asked[q] = 1;
  std::vector<Index> part_of(before.faces.size(), invalid_index);
  for (std::size_t f = 0; f < part_of.size(); ++f) {
    for (const Index v : before.faces[f]) {
      if (vertex_map[v] == invalid_index) continue;
      const Index part = parts.part_of[vertex_map[v]];
      if (part != invalid_index && is_asked[part]) part_of[f] = part;
    }
  }
  return part_of;
}

}  // namespace

PartPairs newly_meeting_parts(const IndexedMesh& before, const IndexedMesh& after, std::span<const Index> vertex_map,
                              unsigned threads) {
  check_vertex_map(vertex_map, before, after);
  bounds_of(after);  // refuses invalid meshes
  const Parts parts = find_parts(after.positions.size(), after.faces);
  if (parts.count < 2) return {};
  std::vector<Index> part_of(after.faces.size());
  for (std::size_t f = 0; f < part_of.size(); ++f) part_of[f] = parts.part_of[after.faces[f][0]];
  const PartPairs now = meeting_parts(after, std::move(part_of), parts.count, threads);
  if (now.empty()) return {};
  bounds_of(before);
  const PartPairs earlier =
      meeting_ones(now, before, parts_before(before, vertex_map, parts, now), parts.count, threads);
  PartPairs newly;
  std::set_difference(now.begin(), now.end(), earlier.begin(), earlier.end(), std::back_inserter(newly));
  return newly;
}

}  // namespace whittle::metrics
