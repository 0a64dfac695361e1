#include "error/error_bound.hh"

#include <algorithm>
#include <atomic>
#include <utility>

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

std::size_t n_blocks_of(std::size_t n) { return (n + faces_per_block(n) - 1) / faces_per_block(n); }

/// Pieces of a face that are looked at before it counts as far: long thin faces take as many as their length has E.
constexpr int most_pieces = 1 << 16;

/// Calls `use(a, b)` with the ends of each edge: edges of triangles, of two faces once, and segments.
template <class Use>
void for_each_edge(const LinkedFaces& surface, const Use& use) {
  for (Index f = 0; f < surface.faces.size(); ++f) {
    const Triangle& face = surface.faces[f];
    const bool is_segment = face[1] == face[2];
    for (std::size_t i = 0; i < (is_segment ? 1 : 3); ++i) {
      const Index other = surface.beyond[f][i];
      if (other == invalid_index || f < other) use(face[i], face[(i + 1) % 3]);
    }
  }
}

detail::IndexLists<Index> neighbours_in(const LinkedFaces& surface) {
  return {surface.positions.size(), [&](const auto& emit) {
            for_each_edge(surface, [&emit](Index a, Index b) {
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

/// Calls `use(face, block, prover, violations)` for each face below `n`, on all threads. Violations are added in order.
/// \param ends_at_first whether other faces needn't be looked at once there is a violation
template <class Use>
void for_each_face(std::size_t n, const ProofTarget& target, unsigned threads, bool ends_at_first, const Use& use,
                   ErrorBound::Violations& violations) {
  const std::size_t size = faces_per_block(n);
  std::vector<ErrorBound::Violations> of_blocks(n_blocks_of(n));
  std::atomic<bool> has_ended = false;
  for_each_block(of_blocks.size(), threads, [&](std::size_t block) {
    Prover prover(target, most_pieces);
    const std::size_t end = std::min(n, (block + 1) * size);
    for (auto f = static_cast<Index>(block * size); f < end && !has_ended; ++f) {
      use(f, block, prover, of_blocks[block]);
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
      neighbours_(neighbours_in(input_.faces())),
      faces_at_(face_at_each_vertex(input.faces, input.positions.size())) {
  input_.build_tree(nullptr);
}

void ErrorBound::add_points(std::span<const FarPoint> points) {
  for (const FarPoint& point : points) {
    points_.push_back(point.position);
    if (!limits_.empty()) point_limits_.push_back(point.limit);
  }
}

ErrorBound::Violations ErrorBound::check(const CheckedSurface& checked, const Question& question) {
  const IndexedMesh& surface = checked.mesh;
  Violations violations;
  if (surface.faces.empty()) {
    for (Index p = 0; p < points_.size(); ++p) violations.points.push_back({points_[p], limit_at(p)});
    return violations;
  }
  const TargetSurface target(surface, checked.frame);
  if (question.is_changed.empty()) {
    found_ = {std::vector<Index>(points_.size(), invalid_index),
              std::vector<std::uint8_t>(points_.size()),
              std::vector<std::uint8_t>(surface.faces.size()),
              {}};
  }
  const auto has_ended = [&] { return question.search == Search::first && !violations.empty(); };
  find_supports(target, checked.vertex_map, question, violations);
  if (!has_ended()) check_surface(target, checked.is_proven, question, violations);
  if (!has_ended()) check_input(target, question, violations);
  return violations;
}

ErrorBound::Violations ErrorBound::check_again(const CheckedSurface& checked,
                                               std::span<const std::uint8_t> is_changed) {
  Question question{limit_, Search::all};
  for (const Triangle& face : checked.mesh.faces) {
    const bool is_any = std::any_of(face.begin(), face.end(), [&](Index v) { return is_changed[v] != 0; });
    question.is_changed.push_back(is_any ? 1 : 0);
  }
  return check(checked, question);
}

bool ErrorBound::has_far_point(const CheckedSurface& checked) {
  if (checked.mesh.faces.empty()) return !points_.empty();
  const TargetSurface surface(checked.mesh, checked.frame);
  Violations violations;
  found_.supports.assign(points_.size(), invalid_index);
  found_.is_far.assign(points_.size(), 0);
  find_supports(surface, checked.vertex_map, {limit_, Search::first}, violations);
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

std::vector<std::uint8_t> ErrorBound::far_vertices(const CheckedSurface& checked, double share) const {
  const std::vector<Vec3>& positions = checked.mesh.positions;
  std::vector<std::uint8_t> is_far(positions.size());
  for_each_range(positions.size(), threads_, [&](std::size_t begin, std::size_t end) {
    Index hint = invalid_index;
    for (std::size_t v = begin; v < end; ++v) {
      const NearFace near = input_.nearest(checked.frame.to_frame(positions[v]), hint);
      hint = near.face;
      is_far[v] = near.distance > share * limit_ ? 1 : 0;
    }
  });
  return is_far;
}

void ErrorBound::check_surface(const TargetSurface& target, std::span<const std::uint8_t> is_proven,
                               const Question& question, Violations& violations) {
  const LinkedFaces faces = target.faces();
  const auto check = [&](Index face, std::size_t, Prover& prover, Violations& found) {
    std::uint8_t& is_proven_now = found_.is_proven[face];
    if (!question.is_changed_at(face) && is_proven_now != 0) return;
    FarthestPoint farthest;
    const bool is_known = !is_proven.empty() && is_proven[face] != 0;
    is_proven_now =
        is_known || prover.prove(faces.corners(face), question.limit, invalid_index, farthest) == Verdict::proven;
    if (is_proven_now != 0) return;
    found.is_surface_far = true;
    add_corners(faces.faces[face], found);
  };
  for_each_face(faces.faces.size(), input_, threads_, question.search == Search::first, check, violations);
}

/// Finds the nearest face, or any that is near. Once any violation will do and there is one, other points have none.
void ErrorBound::find_supports(const TargetSurface& target, std::span<const Index> vertex_map, const Question& question,
                               Violations& violations) {
  const LinkedFaces faces = target.faces();
  const detail::IndexLists<Index> at_vertices = faces_at_vertices(faces);
  std::atomic<bool> has_ended = false;
  for_each_range(points_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end && !has_ended; ++p) {
      Index& support = found_.supports[p];
      std::uint8_t& is_far = found_.is_far[p];
      if (support != invalid_index && !question.is_changed_at(support) && is_far == 0) continue;
      const double limit = std::min(question.limit, limit_at(static_cast<Index>(p)));
      std::span<const Index> at_merged;  // faces at the vertex that the point was merged into
      if (p < vertex_map.size()) {
        if (vertex_map[p] == invalid_index) continue;
        at_merged = at_vertices.of(vertex_map[p]);
        const auto is_near = [&](Index f) { return distance_to(faces.corners(f), points_[p]) <= limit; };
        const auto near = std::find_if(at_merged.begin(), at_merged.end(), is_near);
        if (near != at_merged.end()) {
          support = *near;
          is_far = 0;
          continue;
        }
      }
      const NearFace near = target.nearest(points_[p], at_merged.empty() ? invalid_index : at_merged[0]);
      support = near.face;
      is_far = static_cast<std::uint8_t>(near.distance > limit);
      if (question.search == Search::first && is_far != 0) has_ended = true;
    }
  });
  list_supports(target, question.limit, violations);
}

/// For guards, and points that are far.
void ErrorBound::list_supports(const TargetSurface& target, double limit, Violations& violations) {
  const LinkedFaces faces = target.faces();
  supports_.clear();
  for (Index p = 0; p < points_.size(); ++p) {
    const Index support = found_.supports[p];
    if (support == invalid_index) continue;
    supports_.push_back({p, faces.faces[support]});
    if (found_.is_far[p] == 0) continue;
    violations.points.push_back({points_[p], std::min(limit, limit_at(p))});
    add_corners(faces.faces[support], violations);
  }
}

/// Faces whose corners have one support are near: the distance from a face is convex.
void ErrorBound::check_input(const TargetSurface& target, const Question& question, Violations& violations) {
  const LinkedFaces faces = input_.faces();
  const std::vector<Index>& supports = found_.supports;
  const std::size_t n_blocks = n_blocks_of(faces.faces.size());
  std::vector<KeptProofs> before = std::exchange(found_.input_proofs, std::vector<KeptProofs>(n_blocks));
  before.resize(n_blocks);
  std::vector<KeptProofs::Reader> kept(before.begin(), before.end());
  const auto check = [&](Index face, std::size_t block, Prover& prover, Violations& found) {
    const auto& [a, b, c] = faces.faces[face];
    if (supports[a] == supports[b] && supports[b] == supports[c]) return;
    KeptProofs& proofs = found_.input_proofs[block];
    const auto is_changed = [&](Index by) { return question.is_changed_at(by); };
    if (!question.is_changed.empty() && kept[block].find(face) &&
        std::none_of(kept[block].by().begin(), kept[block].by().end(), is_changed)) {
      return proofs.add(face, kept[block].by());
    }
    FarthestPoint farthest;
    const double limit = limit_of(face, question.limit);
    if (prover.prove(faces.corners(face), limit, supports[a], farthest) == Verdict::proven) {
      return proofs.add(face, prover.faces());
    }
    found.points.push_back({farthest.point, limit});
    add_corners(target.faces().faces[target.nearest(farthest.point, supports[a]).face], found);
  };
  for_each_face(faces.faces.size(), target, threads_, question.search == Search::first, check, violations);
}

}  // namespace whittle
