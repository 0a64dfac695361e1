#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fuzz/check/promise.hh"
#include "fuzz/decode/mesh_bytes.hh"
#include "fuzz/targets.hh"
#include "oracle/clipping.hh"
#include "oracle/point_distance.hh"
#include "support/topology.hh"
#include "support/transforms.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/geometry/triangle_tree.hh"
#include "whittle/core/parts.hh"
#include "whittle/metrics/crossing_walls.hh"
#include "whittle/metrics/distance.hh"
#include "whittle/metrics/line_distance.hh"
#include "whittle/metrics/meeting_parts.hh"
#include "whittle/metrics/nearest_vertices.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/shape.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::test {
namespace {

/// What the functions of this module take: faces, and coordinates in range where a face has them.
bool is_surface(const IndexedMesh& mesh) {
  const auto is_sound = [&mesh](const Triangle& f) {
    return std::all_of(f.begin(), f.end(), [&mesh](Index v) { return is_in_range(mesh.positions[v]); });
  };
  return !mesh.faces.empty() && std::all_of(mesh.faces.begin(), mesh.faces.end(), is_sound);
}

/// Calls `measure`. It is to throw std::invalid_argument exactly if the meshes are no surfaces.
template <class Measure>
auto measured(bool are_surfaces, const Measure& measure) -> std::optional<decltype(measure())> {
  try {
    auto result = measure();
    require(are_surfaces, "what is no surface is refused");
    return result;
  } catch (const std::invalid_argument& refusal) {
    require(!are_surfaces, "surfaces are taken", refusal.what());
    return std::nullopt;
  }
}

void check_topology(const IndexedMesh& mesh) {
  const metrics::Topology t = metrics::topology(mesh);
  const Topology expected = topology(mesh);
  const auto n = [](int count) { return static_cast<std::size_t>(count); };
  require(t.vertices == n(expected.vertices) && t.edges == n(expected.edges) &&
              t.faces + t.collapsed_faces == n(expected.faces) && t.collapsed_faces == n(expected.degenerate_faces),
          "vertices, edges and faces are counted");
  require(t.components == n(expected.components) && t.euler == expected.euler(), "parts are counted");
  require(t.boundary_edges == n(expected.border_edges) && t.nonmanifold_edges == n(expected.nonmanifold_edges) &&
              t.misoriented_edges == n(expected.misoriented_edges),
          "edges of all kinds are counted");
  require(t.manifold == (expected.manifold() && expected.degenerate_faces == 0), "manifolds are known");
  require(t.closed == (expected.closed() && t.faces > 0), "closed surfaces are known");
  require(t.genus.has_value() == (t.manifold && t.closed && t.orientable), "some surfaces have a genus");
  require(!t.oriented || t.orientable, "what is oriented is orientable");
  if (expected.manifold()) require(t.boundary_loops == n(expected.border_loops), "loops are counted");
}

void check_shape(const IndexedMesh& mesh) {
  const auto s = measured(is_surface(mesh), [&mesh] { return metrics::shape(mesh); });
  if (!s) return;
  const auto is_in = [](double x, double high) { return x >= 0 && x <= high; };
  require(is_in(s->radius_ratio_mean, 1 + 1e-12) && is_in(s->radius_ratio_min, s->radius_ratio_mean + 1e-12),
          "radius ratios lie in [0, 1]");
  require(is_in(s->min_angle_mean_deg, 60 + 1e-9) && is_in(s->min_angle_min_deg, s->min_angle_mean_deg + 1e-9),
          "least angles lie in [0, 60]");
  require(s->degenerate_faces <= mesh.faces.size(), "degenerate faces are faces");
  require(std::isfinite(s->edge_length_mean) && s->edge_length_mean >= 0, "lengths are numbers");
  require(std::isfinite(s->edge_length_cv) && s->edge_length_cv >= 0, "deviations are numbers");
  require(is_in(s->valence.share_5_to_7, 1), "shares lie in [0, 1]");
}

void check_intersections(const IndexedMesh& mesh, std::uint64_t hash) {
  const auto pairs = measured(is_surface(mesh), [&mesh] { return metrics::self_intersections(mesh, 1); });
  if (!pairs) return;
  const auto is_small = [](const Vec3& p) { return p.cwiseAbs().maxCoeff() <= 8 && p == Vec3(p.array().round()); };
  if (std::all_of(mesh.positions.begin(), mesh.positions.end(), is_small)) {
    require(*pairs == intersections_by_clipping(mesh), "intersections are those found by clipping");
  }
  const double size = diagonal(mesh);
  if (size > 1e-50 && size < 1e50 && has_ordinary_sizes(mesh)) {
    require(metrics::self_intersections(scaled(mesh, 0x1p30), 1) == *pairs, "intersections don't depend on the unit");
  }
  if (hash % 64 == 1) require(metrics::self_intersections(mesh, 3) == *pairs, "threads change nothing");
}

/// \param limit what no distance can exceed
void check_directed(const metrics::DirectedDistance& d, double limit) {
  require(d.mean >= 0 && d.mean <= d.rms * (1 + 1e-9) && d.rms <= d.max * (1 + 1e-9) && d.max <= limit,
          "means are in order");
  require(std::abs(d.mean_sq - d.rms * d.rms) <= 1e-9 * d.mean_sq, "the root is that of the mean square");
  require(d.normal_deviation_deg >= 0 && d.normal_deviation_deg <= 180, "angles lie in [0, 180]");
  require(d.flipped_percent >= 0 && d.flipped_percent <= 100, "shares lie in [0, 100]");
}

/// The greatest distance of a vertex of `from` from the surface `to`.
double farthest_vertex(const IndexedMesh& from, const IndexedMesh& to) {
  long double farthest = 0;
  for (const Triangle& face : from.faces) {
    for (const Index v : face) farthest = std::max(farthest, distance_by_features(to, from.positions[v]));
  }
  return static_cast<double>(farthest);
}

double extent(const IndexedMesh& mesh) {
  double greatest = 0;
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) greatest = std::max(greatest, mesh.positions[v].cwiseAbs().maxCoeff());
  }
  return greatest;
}

void check_self_distance(const IndexedMesh& mesh) {
  const auto d = measured(is_surface(mesh), [&mesh] {
    return metrics::surface_distance(mesh, mesh, {.samples = 40, .seed = 1, .threads = 1});
  });
  if (!d) return;
  require(d->mean == 0 && d->rms == 0 && d->max == 0 && d->garland_heckbert == 0,
          "a mesh is at distance 0 from itself");
}

void check_distance(const IndexedMesh& a, const IndexedMesh& b, std::uint64_t hash) {
  const metrics::DistanceOptions options{.samples = 60, .seed = hash, .threads = 1};
  const auto d = measured(is_surface(a) && is_surface(b), [&] { return metrics::surface_distance(a, b, options); });
  if (!d) return;
  const auto swapped = metrics::surface_distance(b, a, options);
  const double size = std::max(extent(a), extent(b));
  check_directed(d->forward, 4 * size);
  check_directed(d->backward, 4 * size);
  // The samples differ, and so do the origins; vertices are the same. On a face no point is farther than a corner by
  // more than the face is long.
  const double rounding = 1e-9 * size;
  if (size > 1e-50 && size < 1e50) {
    const auto check_max = [&](double max, double max_swapped, const IndexedMesh& from, const IndexedMesh& to) {
      const double farthest = farthest_vertex(from, to);
      require(max >= farthest - rounding && max_swapped >= farthest - rounding,
              "no vertex is farther than the maximum");
      const double bound = farthest + 4 * extent(from) + rounding;
      require(max <= bound && max_swapped <= bound, "no point is farther than a face reaches");
    };
    check_max(d->forward.max, swapped.backward.max, a, b);
    check_max(d->backward.max, swapped.forward.max, b, a);
  }
  require(
      std::abs(d->forward.mean - swapped.backward.mean) <= std::max(d->forward.max, swapped.backward.max) + rounding,
      "swapped, the directions are swapped");
  if (hash % 64 == 2) {
    metrics::DistanceOptions one = options;
    one.samples = 5000;
    metrics::DistanceOptions three = one;
    three.threads = 3;
    const auto x = metrics::surface_distance(a, b, one);
    const auto y = metrics::surface_distance(a, b, three);
    require(x.mean == y.mean && x.max == y.max && x.garland_heckbert == y.garland_heckbert &&
                x.normal_deviation_deg == y.normal_deviation_deg,
            "threads change nothing");
  }
}

using LinesOf = std::vector<metrics::Segment> (*)(const IndexedMesh&);

void check_lines(const IndexedMesh& a, const IndexedMesh& b, LinesOf lines_of) {
  const auto from = measured(is_surface(a), [&] { return lines_of(a); });
  const auto to = measured(is_surface(b), [&] { return lines_of(b); });
  if (!from || !to) return;
  const metrics::LineDistanceOptions options{.spacing_rel = 0.1, .threads = 1};
  const auto self = metrics::line_distance(*from, *from, options);
  require(self.has_value() == !from->empty(), "lines have a distance where there are some");
  require(!self || (self->mean == 0 && self->max == 0), "lines are at distance 0 from themselves");
  const auto d = metrics::line_distance(*from, *to, options);
  const auto swapped = metrics::line_distance(*to, *from, options);
  require(d.has_value() == (!from->empty() && !to->empty()) && swapped.has_value() == d.has_value(),
          "lines have a distance where there are some");
  if (!d) return;
  const double rounding = 1e-9 * std::max(extent(a), extent(b));
  const auto are_near = [rounding](double x, double y) { return std::abs(x - y) <= rounding; };
  require(are_near(d->mean, swapped->mean) && are_near(d->max, swapped->max), "line distances are symmetric");
  require(are_near(d->forward.max, swapped->backward.max), "swapped, the directions are swapped");
  require(d->mean >= 0 && d->mean <= d->max + rounding, "means are in order");
}

void check_nearest_vertices(const IndexedMesh& a, const IndexedMesh& b) {
  const auto nearest = measured(is_surface(a) && is_surface(b), [&] { return metrics::nearest_vertices(a, b, 1); });
  if (!nearest) return;
  require(nearest->size() == a.positions.size(), "there is a nearest vertex a vertex");
  std::vector<bool> is_used(a.positions.size());
  for (const Triangle& face : a.faces) {
    for (const Index v : face) is_used[v] = true;
  }
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    require(((*nearest)[v] == invalid_index) == !is_used[v], "vertices of faces have a nearest vertex");
    require(!is_used[v] || (*nearest)[v] < b.positions.size(), "the nearest vertex is one of the other mesh");
  }
}

/// A mesh and itself, with one vertex moved: parts that meet are parts, and none meet in what didn't change. The same
/// of faces that cross.
void check_new_intersections(const IndexedMesh& mesh, const IndexedMesh& moved) {
  std::vector<Index> same(mesh.positions.size());
  std::iota(same.begin(), same.end(), Index{0});
  const auto none = measured(is_surface(mesh), [&] { return metrics::newly_meeting_parts(mesh, mesh, same, 1); });
  const bool is_exact = has_ordinary_sizes(mesh);
  require(!none || none->empty() || !is_exact, "no parts newly meet in the same mesh");
  const auto no_faces = measured(is_surface(mesh), [&] { return metrics::newly_crossing_faces(mesh, mesh, same, 1); });
  require(!no_faces || no_faces->empty(), "no faces newly cross in the same mesh");
  if (moved.faces != mesh.faces || moved.positions.size() != mesh.positions.size()) return;
  if (!is_surface(mesh) || !is_surface(moved)) return;
  const std::size_t n_parts = find_parts(moved.positions.size(), moved.faces).count;
  for (const auto& [low, high] : metrics::newly_meeting_parts(mesh, moved, same, 1)) {
    require(low < high && high < n_parts, "parts that meet are parts");
  }
  for (const auto& [low, high] : metrics::newly_crossing_faces(mesh, moved, same, 1)) {
    require(low < high && high < moved.faces.size(), "faces that cross are faces");
  }
}

void check_bounds(const IndexedMesh& mesh) {
  const auto box = measured(is_surface(mesh), [&mesh] { return bounds_of(mesh); });
  if (!box) return;
  require(box->min().allFinite() && box->max().allFinite() && box->center().allFinite(), "boxes are finite");
  require((box->min().array() <= box->center().array()).all() && (box->center().array() <= box->max().array()).all(),
          "the center is inside");
  require(std::isfinite(diagonal_of(*box)), "diagonals are finite");
}

void check(const IndexedMesh& a, const IndexedMesh& b, std::uint64_t hash) {
  check_topology(a);
  check_bounds(a);
  check_shape(a);
  check_intersections(a, hash);
  check_self_distance(a);
  check_distance(a, b, hash);
  check_lines(a, b, metrics::border_lines);
  check_lines(a, b, [](const IndexedMesh& mesh) { return metrics::feature_lines(mesh, 40); });
  check_nearest_vertices(a, b);
  check_new_intersections(a, b);
}

}  // namespace

void fuzz_metrics(std::string_view bytes) {
  ByteSource source(bytes);
  const bool is_same_shape = source.one_in(4);
  const IndexedMesh a = decode_mesh(source);
  IndexedMesh b = is_same_shape ? a : decode_mesh(source);
  if (is_same_shape && !b.positions.empty()) b.positions[source.below(1)] += Vec3(source.real(-1, 1), 0, 0);
  try {
    check(a, b, hash_of(bytes));
  } catch (const std::exception& error) {
    throw BrokenPromise(error.what() + std::string("\n") + text_of(a) + text_of(b));
  }
}

}  // namespace whittle::test
