#include "error/error_bound.hh"

#include <algorithm>
#include <atomic>
#include <utility>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/proof/face_limits.hh"
#include "whittle/core/geometry/proof/prover.hh"

namespace whittle {
namespace {

/// Faces that a thread takes at a time, of `n`: a few long ones may take as long as a thousand others. What is found
/// for them depends on no others.
std::size_t faces_per_block(std::size_t n) {
  constexpr std::size_t n_blocks = 64;
  return std::clamp<std::size_t>(n / n_blocks, 16, 1024);
}

/// Pieces of a face that are looked at before it counts as far: long thin faces take as many as their length has E.
constexpr int most_pieces = 1 << 16;

/// Calls `use(a, b)` with the ends of each edge, once: edges of triangles, and segments.
template <class Use>
void for_each_edge(const IndexedMesh& mesh, const Use& use) {
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size());
  for (std::size_t e = 0; e < edges.size(); ++e) use(edges[e].a, edges[e].b);
  for (const auto& [a, b, c] : mesh.faces) {
    if (b == c) use(a, b);
  }
}

detail::IndexLists<Index> neighbours_in(const IndexedMesh& mesh) {
  return {mesh.positions.size(), [&](const auto& emit) {
            for_each_edge(mesh, [&emit](Index a, Index b) {
              emit(a, b);
              emit(b, a);
            });
          }};
}

detail::IndexLists<Index> faces_at_vertices(const LinkedFaces& surface) {
  return {surface.positions.size(), [&](const auto& emit) {
            for (Index f = 0; f < surface.faces.size(); ++f) {
              for (const Index v : surface.faces[f]) emit(v, f);
            }
          }};
}

/// Of each face; empty if there are no tolerances.
std::vector<double> limits_in_frame(const IndexedMesh& mesh, const Frame& frame, double limit,
                                    std::span<const double> tolerances) {
  std::vector<double> limits = face_limits(mesh.faces, tolerances, limit * frame.unscale);
  for (double& of_face : limits) of_face = std::min(limit, of_face * frame.scale);
  return limits;
}

/// Of each vertex the least limit of its faces; empty if faces have none of their own.
std::vector<double> limits_at_vertices(const IndexedMesh& mesh, std::span<const double> limits, double limit) {
  if (limits.empty()) return {};
  std::vector<double> at_vertices(mesh.positions.size(), limit);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) at_vertices[v] = std::min(at_vertices[v], limits[f]);
  }
  return at_vertices;
}

/// Calls `use(face, prover, violations)` for each face below `n`, on all threads. Violations are added in order.
/// \param ends_at_first whether other faces needn't be looked at once there is a violation
template <class Use>
void for_each_face(std::size_t n, const ProofTarget& target, unsigned threads, bool ends_at_first, const Use& use,
                   ErrorBound::Violations& violations) {
  const std::size_t size = faces_per_block(n);
  std::vector<ErrorBound::Violations> of_blocks((n + size - 1) / size);
  std::atomic<bool> has_ended = false;
  for_each_block(of_blocks.size(), threads, [&](std::size_t block) {
    Prover prover(target, most_pieces);
    const std::size_t end = std::min(n, (block + 1) * size);
    for (auto f = static_cast<Index>(block * size); f < end && !has_ended; ++f) {
      use(f, prover, of_blocks[block]);
      if (ends_at_first && !of_blocks[block].empty()) has_ended = true;
    }
  });
  for (const ErrorBound::Violations& found : of_blocks) violations.add(found);
}

void add_corners(const Triangle& face, ErrorBound::Violations& violations) {
  violations.vertices.insert(violations.vertices.end(), face.begin(), face.end());
}

}  // namespace

void ErrorBound::Violations::add(const Violations& other) {
  is_surface_far |= other.is_surface_far;
  points.insert(points.end(), other.points.begin(), other.points.end());
  vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
}

ErrorBound::ErrorBound(const IndexedMesh& input, const Frame& frame, double limit, unsigned threads,
                       std::span<const double> tolerances)
    : limits_(limits_in_frame(input, frame, limit, tolerances)),
      input_(input, frame, limits_, limit),
      limit_(limit),
      threads_(threads),
      points_(input_.faces().positions.begin(), input_.faces().positions.end()),
      point_limits_(limits_at_vertices(input, limits_, limit)),
      neighbours_(neighbours_in(input)),
      faces_at_(input.positions.size(), invalid_index) {
  for (Index f = 0; f < input.faces.size(); ++f) {
    for (const Index v : input.faces[f]) faces_at_[v] = f;
  }
  input_.build_tree(nullptr);
}

void ErrorBound::add_points(std::span<const FarPoint> points) {
  for (const FarPoint& point : points) {
    points_.push_back(point.position);
    if (!limits_.empty()) point_limits_.push_back(point.limit);
  }
}

ErrorBound::Violations ErrorBound::check(const CheckedSurface& checked, double limit, Search search) {
  const IndexedMesh& surface = checked.mesh;
  Violations violations;
  if (surface.faces.empty()) {
    for (Index p = 0; p < points_.size(); ++p) violations.points.push_back({points_[p], limit_at(p)});
    return violations;
  }
  const TargetSurface target(surface, checked.frame);
  const auto has_ended = [&] { return search == Search::first && !violations.empty(); };
  const std::vector<Index> supports = find_supports(target, checked.vertex_map, limit, search, violations);
  if (!has_ended()) check_surface(target, checked.is_proven, limit, search, violations);
  if (!has_ended()) check_input(target, supports, limit, search, violations);
  return violations;
}

bool ErrorBound::has_far_point(const CheckedSurface& checked) {
  if (checked.mesh.faces.empty()) return !points_.empty();
  const TargetSurface surface(checked.mesh, checked.frame);
  Violations violations;
  find_supports(surface, checked.vertex_map, limit_, Search::first, violations);
  return !violations.empty() || has_far_point_on(surface);
}

bool ErrorBound::has_far_point_on(const TargetSurface& surface) const {
  const LinkedFaces faces = surface.faces();
  std::atomic<bool> is_found = false;
  for_each_range(faces.faces.size(), threads_, [&](std::size_t begin, std::size_t end) {
    Index hint = invalid_index;
    const auto is_far = [&](const Vec3& point) {
      const NearFace near = input_.nearest(point, hint);
      hint = near.face;
      return near.distance > limit_;
    };
    for (std::size_t f = begin; f < end && !is_found; ++f) {
      const Corners corners = faces.corners(static_cast<Index>(f));
      for (std::size_t i = 0; i < 3; ++i) {
        if (is_far(corners[i]) || is_far(0.5 * (corners[i] + corners[(i + 1) % 3]))) is_found = true;
      }
    }
  });
  return is_found;
}

void ErrorBound::check_surface(const TargetSurface& surface, std::span<const std::uint8_t> is_proven, double limit,
                               Search search, Violations& violations) const {
  const LinkedFaces faces = surface.faces();
  const auto check = [&](Index face, Prover& prover, Violations& found) {
    if (!is_proven.empty() && is_proven[face] != 0) return;
    FarthestPoint farthest;
    const Verdict verdict = prover.prove(faces.corners(face), limit, invalid_index, farthest);
    if (verdict == Verdict::proven) return;
    found.is_surface_far = true;
    add_corners(faces.faces[face], found);
  };
  for_each_face(faces.faces.size(), input_, threads_, search == Search::first, check, violations);
}

/// Finds the nearest face, or any that is near.
/// \return of each point, a face of the surface; `invalid_index` for vertices that are in no face. Once any violation
///         will do and there is one, for other points, too
std::vector<Index> ErrorBound::find_supports(const TargetSurface& surface, std::span<const Index> vertex_map,
                                             double limit, Search search, Violations& violations) {
  const LinkedFaces faces = surface.faces();
  const detail::IndexLists<Index> at_vertices = faces_at_vertices(faces);
  std::vector<Index> supports(points_.size(), invalid_index);
  std::vector<std::uint8_t> is_far(points_.size());
  const auto limit_of = [&](std::size_t p) { return std::min(limit, limit_at(static_cast<Index>(p))); };
  std::atomic<bool> has_ended = false;
  for_each_range(points_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end && !has_ended; ++p) {
      std::span<const Index> at_merged;  // faces at the vertex that the point was merged into
      if (p < vertex_map.size()) {
        if (vertex_map[p] == invalid_index) continue;
        at_merged = at_vertices.of(vertex_map[p]);
        const auto is_near = [&](Index f) { return distance_to(faces.corners(f), points_[p]) <= limit_of(p); };
        const auto near = std::find_if(at_merged.begin(), at_merged.end(), is_near);
        if (near != at_merged.end()) {
          supports[p] = *near;
          continue;
        }
      }
      const NearFace near = surface.nearest(points_[p], at_merged.empty() ? invalid_index : at_merged[0]);
      supports[p] = near.face;
      is_far[p] = static_cast<std::uint8_t>(near.distance > limit_of(p));
      if (search == Search::first && is_far[p] != 0) has_ended = true;
    }
  });
  supports_.clear();
  for (Index p = 0; p < points_.size(); ++p) {
    if (supports[p] == invalid_index) continue;
    supports_.push_back({p, faces.faces[supports[p]]});
    if (is_far[p] == 0) continue;
    violations.points.push_back({points_[p], limit_of(p)});
    add_corners(faces.faces[supports[p]], violations);
  }
  return supports;
}

/// Faces whose corners have one support are near: the distance from a face is convex.
void ErrorBound::check_input(const TargetSurface& surface, std::span<const Index> supports, double limit, Search search,
                             Violations& violations) const {
  const LinkedFaces faces = input_.faces();
  const auto check = [&](Index face, Prover& prover, Violations& found) {
    const auto& [a, b, c] = faces.faces[face];
    if (supports[a] == supports[b] && supports[b] == supports[c]) return;
    FarthestPoint farthest;
    const Verdict verdict = prover.prove(faces.corners(face), limit_of(face, limit), supports[a], farthest);
    if (verdict == Verdict::proven) return;
    found.points.push_back({farthest.point, limit_of(face, limit)});
    add_corners(surface.faces().faces[surface.nearest(farthest.point, supports[a]).face], found);
  };
  for_each_face(faces.faces.size(), surface, threads_, search == Search::first, check, violations);
}

}  // namespace whittle
