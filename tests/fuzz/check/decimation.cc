#include "fuzz/check/decimation.hh"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <span>
#include <string>

#include "fuzz/check/promise.hh"
#include "fuzz/decode/mesh_bytes.hh"
#include "oracle/crossing.hh"
#include "support/transforms.hh"
#include "whittle/core/detail/checks.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/core/frame.hh"
#include "whittle/core/geometry/radius_ratio.hh"
#include "whittle/core/geometry/triangle_intersection.hh"
#include "whittle/core/two_sided.hh"
#include "whittle/core/wedges.hh"
#include "whittle/metrics/certify.hh"
#include "whittle/metrics/self_intersections.hh"
#include "whittle/metrics/topology.hh"

namespace whittle::test {
namespace {

bool has_pairs(const DecimateCase& c) { return c.options.pairs.threshold > 0; }

/// Whether no contraction may change the topology.
bool keeps_topology(const DecimateCase& c) { return c.options.topology == whittle::Topology::keep && !has_pairs(c); }

bool is_manifold(const metrics::Topology& t) { return t.nonmanifold_edges == 0 && t.nonmanifold_vertices == 0; }

std::vector<bool> used_vertices(const IndexedMesh& mesh) {
  std::vector<bool> is_used(mesh.positions.size());
  for (const Triangle& face : mesh.faces) {
    if (!has_three_corners(face)) continue;
    for (const Index v : face) is_used[v] = true;
  }
  return is_used;
}

/// The input's vertex that each vertex of the result stands for.
std::vector<Index> origins_in_input(const DecimateCase& c, const Decimation& d) {
  if (c.mesh.origins.empty()) return d.mesh.origins;
  std::vector<Index> result;
  for (const Index origin : d.mesh.origins) {
    const auto at = std::lower_bound(c.mesh.origins.begin(), c.mesh.origins.end(), origin);
    require(at != c.mesh.origins.end() && *at == origin, "origins are those of the input");
    result.push_back(static_cast<Index>(at - c.mesh.origins.begin()));
  }
  return result;
}

void check_maps(const DecimateCase& c, const Decimation& d) {
  const std::size_t n = d.mesh.positions.size();
  require(d.vertex_map.size() == c.mesh.positions.size(), "the vertex map is total");
  const std::vector<bool> is_used = used_vertices(c.mesh);
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    const Index to = d.vertex_map[v];
    require(to == invalid_index || to < n, "the vertex map names vertices of the result");
    require(is_used[v] || to == invalid_index, "vertices without a face are mapped nowhere");
    // Where faces coincide and vanish, a vertex may lose its last face.
    require(!is_used[v] || to != invalid_index || !keeps_topology(c), "vertices with a face are mapped");
  }
  require(d.mesh.origins.size() == n, "there is an origin a vertex");
  require(std::is_sorted(d.mesh.origins.begin(), d.mesh.origins.end()), "origins ascend");
  const std::vector<Index> origins = origins_in_input(c, d);
  for (std::size_t v = 0; v < n; ++v) require(d.vertex_map[origins[v]] == v, "origins are mapped to their vertices");
  require(d.face_origins.size() == d.mesh.faces.size(), "there is an origin a face");
  for (std::size_t f = 0; f < d.face_origins.size(); ++f) {
    require(f == 0 || d.face_origins[f - 1] < d.face_origins[f], "origins of faces ascend");
    for (std::size_t i = 0; i < 3; ++i) {
      require(d.mesh.faces[f][i] == d.vertex_map[c.mesh.faces.at(d.face_origins[f])[i]],
              "faces are those of the input");
    }
  }
}

void check_counts(const Decimation& d, const metrics::Topology& before, const metrics::Topology& after) {
  const DecimateResult& result = d.result;
  require(result.n_faces == d.mesh.faces.size(), "faces are counted");
  require(result.n_vertices == d.mesh.positions.size(), "vertices are counted");
  require(result.n_degenerate_faces == before.collapsed_faces, "degenerate faces are counted");
  const auto is_counted = [](const SurfaceCounts& counts, const metrics::Topology& t) {
    return counts.components == t.components && counts.nonmanifold_edges == t.nonmanifold_edges &&
           counts.nonmanifold_vertices == t.nonmanifold_vertices;
  };
  require(is_counted(result.before, before), "the input's surface is counted");
  require(is_counted(result.after, after), "the result's surface is counted");
  require(!d.mesh.faces.empty() || before.faces == 0, "the last face stays");
  require(result.warnings.size() == (result.threshold_pairs.capped ? 1U : 0U), "a warning says what is left out");
}

/// The target is met, or something stands in the way.
void check_stop(const DecimateCase& c, const Decimation& d) {
  const DecimateResult& result = d.result;
  const RefusalCounts& left = result.refused_at_end;
  const std::uint64_t n_left = left.total();
  const bool is_reached = c.target.is_reached_at(result.n_faces, result.n_vertices);
  require((result.stop == StopReason::target) == is_reached || result.stop == StopReason::cancelled,
          "the run stops at the target");
  require(result.stop != StopReason::cost || c.target.cost_limit(), "a run without a cost limit doesn't stop at one");
  require(result.stop != StopReason::cancelled || c.n_calls_left, "only the callback cancels");
  require(result.stop != StopReason::exhausted || d.mesh.faces.empty() || n_left > 0, "a missed target has a reason");
  require(result.stop == StopReason::exhausted || result.stop == StopReason::error || n_left == 0,
          "a target reached has no reason against it");
  require((result.stop != StopReason::error && left[Refusal::error] == 0) || c.target.error_limit(),
          "the error is a reason where it is limited");
  require(left[Refusal::shape] == 0 || c.options.min_radius_ratio > 0, "shape is a reason where asked for");
  require(left[Refusal::intersection] == 0 || c.options.refuse_intersections,
          "intersecting is a reason where asked for");
  require(left[Refusal::locked] == 0 || !c.options.locked.empty() || c.options.boundary == Boundary::locked,
          "being locked is a reason where asked for");
  require(left[Refusal::feature] == 0 || c.options.feature_angle_deg || !c.options.feature_edges.empty() ||
              !c.options.locked.empty() || c.options.boundary == Boundary::locked || !seam_edges(c.mesh).empty(),
          "features are a reason where asked for");
}

void check_contractions(const DecimateCase& c, const Decimation& d, const std::vector<Contraction>& made) {
  double max_cost = 0;
  for (const Contraction& contraction : made) {
    require(is_in_range(contraction.position) || !contraction.position.array().isNaN().any(), "positions are numbers");
    require(!std::isnan(contraction.cost), "costs are numbers");
    require(contraction.survivor != contraction.removed, "two vertices are contracted");
    max_cost = std::max(max_cost, contraction.cost);
  }
  require(d.result.n_contractions == made.size(), "contractions are counted");
  require(d.result.max_cost == max_cost, "the greatest cost is that of a contraction");
  const auto limit = c.target.cost_limit();
  require(!limit || max_cost <= *limit * (1 + 1e-12), "nothing costs more than the limit");
}

/// Of the surface without the backs of the input's two-sided sheets, which come and go with their fronts.
/// \param face_origins of the mesh, in the input
metrics::Topology topology_of_one_side(const IndexedMesh& mesh, std::span<const Index> face_origins,
                                       const IndexedMesh& input) {
  const std::vector<Index> fronts = fronts_of_backs(input);
  IndexedMesh one_side = mesh;
  one_side.faces.clear();
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (fronts.empty() || fronts[face_origins[f]] == invalid_index) one_side.faces.push_back(mesh.faces[f]);
  }
  return metrics::topology(one_side);
}

void check_topology(const DecimateCase& c, const Decimation& d) {
  if (!keeps_topology(c)) return;
  std::vector<Index> all(c.mesh.faces.size());
  std::iota(all.begin(), all.end(), Index{0});
  const metrics::Topology before = topology_of_one_side(c.mesh, all, c.mesh);
  const metrics::Topology after = topology_of_one_side(d.mesh, d.face_origins, c.mesh);
  const DecimateResult& result = d.result;
  require(after.components == before.components, "components are kept");
  require(after.euler == before.euler, "the Euler number is kept");
  require(after.nonmanifold_edges <= before.nonmanifold_edges, "no edge becomes non-manifold");
  require(after.nonmanifold_vertices <= before.nonmanifold_vertices, "no vertex becomes non-manifold");
  require(after.misoriented_edges <= before.misoriented_edges, "orientation is kept");
  require(after.boundary_edges <= before.boundary_edges, "no border edge is added");
  require(result.n_vanished_components == 0, "no part vanishes");
  require(result.n_coincident_faces == 0 || !is_manifold(before), "no faces coincide");
  if (!is_manifold(before)) return;
  require(is_manifold(after), "a manifold stays manifold");
  require(after.boundary_loops == before.boundary_loops, "border loops are kept");
  require(after.orientable == before.orientable, "what is orientable stays so");
  require(before.vertices - after.vertices == result.n_contractions, "each contraction takes a vertex");
}

/// Without faces of which two corners are one, which belong to no surface.
IndexedMesh proper_faces(IndexedMesh mesh) {
  std::erase_if(mesh.faces, [](const Triangle& face) { return !has_three_corners(face); });
  return mesh;
}

void check_error(const DecimateCase& c, const Decimation& d) {
  if (!c.target.error_limit() || d.result.stop == StopReason::cancelled) return;
  const IndexedMesh input = proper_faces(c.mesh);
  if (input.faces.empty()) return;
  require(d.result.proven_error == c.target.error_limit(), "the error that is proven is the limit");
  const double rounding = 1e-12 * (diagonal(c.mesh) + c.mesh.positions[0].norm());
  std::vector<double> tolerances = c.options.tolerances;
  for (double& tolerance : tolerances) tolerance += rounding;
  const double limit = *c.target.error_limit() + rounding;
  const double border_limit = *c.target.border_error_limit() + rounding;
  const metrics::CertifyOptions options{.threads = 1, .tolerances = tolerances};
  require(metrics::certify(input, d.mesh, limit, options).verdict != Verdict::refuted,
          "no point is farther than the limit of the error");
  require(metrics::certify_borders(input, d.mesh, border_limit, {.threads = 1}).verdict != Verdict::refuted,
          "no point of a border is farther than the limit of the error");
}

/// Vertices at edges that don't have exactly two faces.
std::set<Index> border_vertices(const IndexedMesh& mesh) {
  std::vector<VertexPair> sides;
  for (const Triangle& face : mesh.faces) {
    if (!has_three_corners(face)) continue;
    for (std::size_t i = 0; i < 3; ++i)
      sides.push_back({std::min(face[i], face[(i + 1) % 3]), std::max(face[i], face[(i + 1) % 3])});
  }
  std::sort(sides.begin(), sides.end());
  std::set<Index> result;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end = std::upper_bound(begin, sides.end(), *begin);
    if (end - begin == 1) result.insert({begin->a, begin->b});
    begin = end;
  }
  return result;
}

void check_locked(const DecimateCase& c, const Decimation& d) {
  const DecimateOptions& options = c.options;
  if (options.locked.empty() && options.boundary != Boundary::locked) return;
  const std::set<Index> border = border_vertices(c.mesh);
  const std::vector<bool> is_used = used_vertices(c.mesh);
  const std::vector<Index> origins = origins_in_input(c, d);
  for (Index v = 0; v < is_used.size(); ++v) {
    const bool is_locked = (!options.locked.empty() && options.locked[v] != 0) ||
                           (options.boundary == Boundary::locked && border.contains(v));
    if (!is_locked || !is_used[v]) continue;
    const Index to = d.vertex_map[v];
    if (to == invalid_index && !keeps_topology(c)) continue;  // it has lost its faces
    require(origins[to] == v, "locked vertices don't vanish");
    require(d.mesh.positions[to] == c.mesh.positions[v], "locked vertices don't move");
  }
}

void check_shape(const DecimateCase& c, const Decimation& d) {
  const double limit = c.options.min_radius_ratio.value_or(0);
  if (!(limit > 0) || d.result.n_coincident_faces > 0 || !has_ordinary_sizes(c.mesh)) return;
  const auto ratio = [](const IndexedMesh& mesh, const Triangle& f) {
    const Frame frame = Frame::of_points(mesh.positions);
    const auto at = [&](std::size_t i) { return frame.to_frame(mesh.positions[f[i]]); };
    return radius_ratio(at(0), at(1), at(2));
  };
  for (std::size_t f = 0; f < d.mesh.faces.size(); ++f) {
    const double before = ratio(c.mesh, c.mesh.faces[d.face_origins[f]]);
    require(ratio(d.mesh, d.mesh.faces[f]) >= std::min(limit, before) - 1e-9, "no face becomes thinner than allowed");
  }
}

void check_placement(const DecimateCase& c, const Decimation& d) {
  if (c.options.quadric.placement != Placement::endpoint) return;
  const std::vector<Index> origins = origins_in_input(c, d);
  for (std::size_t v = 0; v < origins.size(); ++v) {
    require(d.mesh.positions[v] == c.mesh.positions[origins[v]], "each vertex has the position of its origin");
  }
}

/// Whether rounding decides the normal of one of the faces that `is_meant`.
template <class IsMeant>
bool has_thin_face(const IndexedMesh& mesh, const IsMeant& is_meant) {
  const Frame frame = Frame::of_points(mesh.positions);
  return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const Triangle& f) {
    const auto at = [&](std::size_t i) { return frame.to_frame(mesh.positions[f[i]]); };
    return is_meant(f) && radius_ratio(at(0), at(1), at(2)) < 1e-6;
  });
}

bool is_thin_at(const IndexedMesh& mesh, const VertexPair& edge) {
  return has_thin_face(mesh, [&edge](const Triangle& f) {
    const auto has = [&f](Index v) { return std::find(f.begin(), f.end(), v) != f.end(); };
    return has(edge.a) && has(edge.b);
  });
}

std::string edge_text(const VertexPair& edge) {
  return ": edge " + std::to_string(edge.a) + ' ' + std::to_string(edge.b);
}

/// Feature edges stay sharp, and no others get so. Angles within a ten thousandth of a degree of the limit are left to
/// rounding, and so are edges of thin faces. A thin face of the input may hide that its neighbours are a fold: no edge
/// is sharp before it vanishes.
void check_features(const DecimateCase& c, const Decimation& d, const metrics::Topology& before) {
  const std::vector<VertexPair>& features = d.feature_edges;
  require(std::is_sorted(features.begin(), features.end()), "feature edges ascend");
  for (const auto& [a, b] : features) {
    require(a < b && b < d.mesh.positions.size(), "feature edges have the lower vertex first");
  }
  constexpr double rounding_deg = 1e-4;
  const double angle_deg = c.options.feature_angle_deg.value_or(180);
  if (angle_deg + rounding_deg >= 180 || !keeps_topology(c) || !is_manifold(before) || !has_ordinary_sizes(c.mesh)) {
    return;
  }
  const bool hides_folds = has_thin_face(c.mesh, [](const Triangle&) { return true; });
  for (const VertexPair& edge : feature_edges(d.mesh, angle_deg + rounding_deg)) {
    require(hides_folds || std::binary_search(features.begin(), features.end(), edge) || is_thin_at(d.mesh, edge),
            "no other edges get sharp", edge_text(edge));
  }
  if (!c.options.feature_edges.empty() || !seam_edges(c.mesh).empty()) return;  // those may be flat
  const std::vector<VertexPair> sharp = feature_edges(d.mesh, std::max(0.0, angle_deg - rounding_deg));
  for (const VertexPair& edge : features) {
    require(std::binary_search(sharp.begin(), sharp.end(), edge) || is_thin_at(d.mesh, edge), "features stay sharp",
            edge_text(edge));
  }
}

/// Whether faces without a common edge touch, as far as rounding lets tell: they may count as intersecting already.
bool has_touching_faces(const IndexedMesh& mesh) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (std::size_t g = 0; g < f; ++g) {
      if (n_common_corners(mesh.faces[f], mesh.faces[g]) > 1) continue;
      if (detail::intersect(mesh.faces[f], mesh.faces[g], mesh.positions)) return true;
    }
  }
  return false;
}

/// Where nothing intersected or touched, nothing intersects.
void check_intersections(const DecimateCase& c, const Decimation& d) {
  if (!c.options.refuse_intersections || c.mesh.faces.empty() || !has_ordinary_sizes(c.mesh)) return;
  if (clear_crossings(d.mesh).empty() || has_touching_faces(c.mesh)) return;
  require(!metrics::self_intersections(c.mesh, 1).empty(), "no intersection is made where that is refused");
}

void check_attributes(const DecimateCase& c, const Decimation& d) {
  const bool has_normals = !c.mesh.normals.empty() && !d.mesh.positions.empty() && c.options.normals != Normals::drop;
  require(d.mesh.normals.empty() != has_normals, "normals stay unless told otherwise");
  require(d.mesh.colors.empty() == (c.mesh.colors.empty() || d.mesh.positions.empty()), "colours stay");
  for (const Color& color : d.mesh.colors) {
    for (const float x : color) require(x >= 0 && x <= 1, "colours lie in [0, 1]");
  }
  const bool keeps_quadrics = c.options.keep_quadrics && cost_traits(c.options.effective_cost()).has_quadrics;
  require(!keeps_quadrics || d.quadrics.size() == d.mesh.positions.size(), "there is a quadric a vertex");
}

}  // namespace

void check_sound(const IndexedMesh& mesh) {
  const std::size_t n = mesh.positions.size();
  for (const Vec3& p : mesh.positions) require(p.allFinite(), "positions are finite");
  for (const Triangle& face : mesh.faces) {
    require(face[0] < n && face[1] < n && face[2] < n, "corners are vertices");
    require(has_three_corners(face), "no face has two equal corners");
  }
  const std::vector<bool> is_used = used_vertices(mesh);
  require(std::all_of(is_used.begin(), is_used.end(), [](bool x) { return x; }), "every vertex has a face");
  require(mesh.normals.empty() || mesh.normals.size() == n_wedges(mesh), "there is a normal a wedge");
  require(mesh.colors.empty() || mesh.colors.size() == n_wedges(mesh), "there is a colour a wedge");
  for (const auto& [x, y, z] : mesh.normals) {
    const float length = std::sqrt(x * x + y * y + z * z);
    require(std::abs(length - 1) < 1e-5F || length == 0, "normals have unit length, or none");
  }
}

void check_decimation(const DecimateCase& c, const Decimation& d, const std::vector<Contraction>& made) {
  check_sound(d.mesh);
  const metrics::Topology before = metrics::topology(c.mesh);
  const metrics::Topology after = metrics::topology(d.mesh);
  check_maps(c, d);
  check_counts(d, before, after);
  check_error(c, d);
  check_stop(c, d);
  check_contractions(c, d, made);
  check_topology(c, d);
  check_locked(c, d);
  check_shape(c, d);
  check_placement(c, d);
  check_features(c, d, before);
  check_intersections(c, d);
  check_attributes(c, d);
}

void check_same(const Decimation& d, const Decimation& other, const char* promise) {
  require(d.mesh.positions == other.mesh.positions, promise);
  require(d.mesh.faces == other.mesh.faces, promise);
  require(d.mesh.normals == other.mesh.normals, promise);
  require(d.mesh.colors == other.mesh.colors, promise);
  require(d.vertex_map == other.vertex_map, promise);
  require(d.face_origins == other.face_origins, promise);
  require(d.feature_edges == other.feature_edges, promise);
  require(d.result.max_cost == other.result.max_cost, promise);
}

}  // namespace whittle::test
