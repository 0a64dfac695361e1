#include "whittle/engine/decimate.hh"

#include <algorithm>
#include <stdexcept>

#include "cost/make_cost.hh"
#include "decimate/contraction_loop.hh"
#include "host/host_cost.hh"
#include "whittle/core/feature_edges.hh"
#include "whittle/core/geometry/vertex_normals.hh"
#include "whittle/core/parts.hh"
#include "whittle/engine/threshold_pairs.hh"

namespace whittle {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("decimate: ") + what);
}

bool is_finite_and_not_negative(double x) { return x >= 0 && std::isfinite(x); }

void check(const DecimateTarget& target, const DecimateOptions& options, std::size_t n_vertices) {
  require(!target.max_cost || *target.max_cost >= 0, "max_cost is negative or not a number");
  require(is_finite_and_not_negative(options.quadric.regularization), "regularization is negative or not finite");
  require(is_finite_and_not_negative(options.quadric.boundary_weight), "boundary_weight is negative or not finite");
  require(options.max_normal_flip_deg > 0 && options.max_normal_flip_deg <= 180,
          "max_normal_flip_deg is not in (0, 180]");
  require(options.feature_angle_deg > 0 && options.feature_angle_deg <= 180, "feature_angle_deg is not in (0, 180]");
  require(options.feature_tolerance >= 0, "feature_tolerance is negative or not a number");
  require(options.isotropy >= 0 && options.isotropy <= 1, "isotropy is not in [0, 1]");
  require(is_finite_and_not_negative(options.valence_weight), "valence_weight is negative or not finite");
  require(options.min_radius_ratio >= 0 && options.min_radius_ratio <= 1, "min_radius_ratio is not in [0, 1]");
  require(options.isotropy == 0 || options.cost == Cost::quadric, "isotropy blends the quadric cost alone");
  const bool has_quadrics = options.cost == Cost::quadric || options.cost == Cost::memoryless;
  const bool is_plain = has_quadrics && options.isotropy == 0 && options.valence_weight == 0;
  require(options.pairs.threshold == 0 || is_plain, "threshold pairs go with plain quadric costs alone");
  const bool is_exactly_memoryless = options.cost == Cost::memoryless && options.order == Order::exact;
  require(options.pairs.threshold == 0 || !is_exactly_memoryless, "threshold pairs go with no exact memoryless order");
  require(options.quadric.weights == Weights::area || options.cost != Cost::memoryless,
          "memoryless quadrics have weights by area");
  require(options.pairs.threshold >= 0, "pairs.threshold is negative or not a number");
  require(is_finite_and_not_negative(options.quadric.point_weight), "point_weight is negative or not finite");
  require(options.locked.empty() || options.locked.size() == n_vertices, "locked has another length than the vertices");
}

void check(const IndexedMesh& mesh) {
  if (mesh.faces.size() > (std::size_t{1} << 31)) throw std::length_error("decimate: more than 2^31 faces");
  if (mesh.positions.size() >= invalid_index) throw std::length_error("decimate: more than 2^32 - 2 vertices");
  for (const Triangle& face : mesh.faces) {
    for (const Index v : face) {
      if (v < mesh.positions.size()) continue;
      throw std::invalid_argument("decimate: face " + std::to_string(&face - mesh.faces.data()) + " names vertex " +
                                  std::to_string(v) + " of " + std::to_string(mesh.positions.size()));
    }
  }
  for (const Vec3& p : mesh.positions) {
    if (p.allFinite()) continue;
    throw std::invalid_argument("decimate: vertex " + std::to_string(&p - mesh.positions.data()) +
                                " has a coordinate that is not finite");
  }
}

/// Per vertex of the complex; empty if none is.
std::vector<std::uint8_t> locked_vertices(const TriangleComplex& complex, const DecimateOptions& options) {
  std::vector<std::uint8_t> locked;
  if (options.locked.empty() && options.boundary != Boundary::locked) return locked;
  locked.resize(complex.n_vertex_slots());
  for (Index v = 0; v < locked.size(); ++v) {
    const bool by_user = !options.locked.empty() && options.locked[complex.origin(v)] != 0;
    const bool by_border = options.boundary == Boundary::locked && complex.kind(v) != VertexKind::regular;
    locked[v] = by_user || by_border;
  }
  return locked;
}

/// Ascending.
std::vector<VertexPair> all_feature_edges(const IndexedMesh& mesh, const DecimateOptions& options) {
  std::vector<VertexPair> edges;
  if (options.feature_angle_deg < 180) edges = feature_edges(mesh, options.feature_angle_deg);
  for (const auto& [a, b] : options.feature_edges) edges.push_back({std::min(a, b), std::max(a, b)});
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Where each input vertex went, as a vertex of the complex; `invalid_index` for those without a face.
std::vector<Index> representatives(TriangleComplex& complex) {
  std::vector<Index> result(complex.n_vertex_slots(), invalid_index);
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    const Index r = complex.representative(v);
    if (complex.has_faces(r)) result[complex.origin(v)] = r;
  }
  return result;
}

Triangle mapped(const Triangle& face, const std::vector<Index>& vertex_map) {
  return {vertex_map[face[0]], vertex_map[face[1]], vertex_map[face[2]]};
}

/// Those faces of the input whose corners are still three vertices, by number. \param vertex_map to the complex
std::vector<Index> surviving_faces(std::span<const Triangle> faces, const std::vector<Index>& vertex_map,
                                   std::size_t n_surviving) {
  std::vector<Index> result;
  result.reserve(n_surviving);
  for (Index f = 0; f < faces.size(); ++f) {
    if (has_three_corners(mapped(faces[f], vertex_map))) result.push_back(f);
  }
  return result;
}

/// From `faces`, those that the complex still has: of several laid on one another the first as many as are left.
void leave_out_coincident(std::vector<Index>& faces, std::span<const Triangle> input,
                          const std::vector<Index>& vertex_map, TriangleComplex& complex) {
  const std::vector<Triangle> live = complex.live_faces();
  std::vector<bool> is_found(live.size());
  std::erase_if(faces, [&](Index f) {
    Triangle face = mapped(input[f], vertex_map);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    const auto [begin, end] = std::equal_range(live.begin(), live.end(), face);
    for (auto it = begin; it != end; ++it) {
      const auto place = static_cast<std::size_t>(it - live.begin());
      if (is_found[place]) continue;
      is_found[place] = true;
      return false;
    }
    return true;
  });
}

/// The mean colour of the vertices merged into each vertex of the result.
std::vector<Color> merged_colors(const IndexedMesh& input, const std::vector<Index>& vertex_map,
                                 std::size_t n_vertices) {
  std::vector<std::array<double, 4>> sums(n_vertices);
  std::vector<double> counts(n_vertices);
  for (std::size_t v = 0; v < vertex_map.size(); ++v) {
    if (vertex_map[v] == invalid_index) continue;
    for (std::size_t channel = 0; channel < 4; ++channel) sums[vertex_map[v]][channel] += input.colors[v][channel];
    ++counts[vertex_map[v]];
  }
  std::vector<Color> colors(n_vertices);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
      colors[v][channel] = static_cast<float>(sums[v][channel] / counts[v]);
    }
  }
  return colors;
}

Decimation make_output(const IndexedMesh& input, TriangleComplex& complex, const Frame& frame,
                       const PairCost* quadrics_of) {
  Decimation out;
  out.vertex_map = representatives(complex);
  std::vector<Index> output_of(complex.n_vertex_slots(), invalid_index);
  IndexedMesh& mesh = out.mesh;
  mesh.positions.reserve(complex.n_vertices());
  mesh.origins.reserve(complex.n_vertices());
  if (quadrics_of) out.quadrics.reserve(complex.n_vertices());
  for (Index v = 0; v < out.vertex_map.size(); ++v) {
    const Index r = out.vertex_map[v];
    if (r == invalid_index || complex.origin(r) != v) continue;
    output_of[r] = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(frame.to_model(complex.position(r)));
    mesh.origins.push_back(input.origins.empty() ? v : input.origins[v]);
    if (quadrics_of) out.quadrics.push_back(quadrics_of->quadric(r));
  }
  out.face_origins = surviving_faces(input.faces, out.vertex_map, complex.n_faces());
  if (complex.n_coincident_faces() > 0) leave_out_coincident(out.face_origins, input.faces, out.vertex_map, complex);
  for (Index& r : out.vertex_map) {
    if (r != invalid_index) r = output_of[r];
  }
  mesh.faces.reserve(out.face_origins.size());
  for (const Index f : out.face_origins) mesh.faces.push_back(mapped(input.faces[f], out.vertex_map));
  if (!input.colors.empty()) mesh.colors = merged_colors(input, out.vertex_map, mesh.positions.size());
  if (!input.normals.empty()) mesh.normals = vertex_normals(mesh, frame);
  return out;
}

ThresholdPairs threshold_pairs(const IndexedMesh& mesh, const DecimateOptions& options) {
  const auto& [threshold, max_pairs, across_walls] = options.pairs;
  if (threshold == 0) return {};
  return find_threshold_pairs(mesh.positions, mesh.faces, {threshold, max_pairs, across_walls, options.threads});
}

SurfaceCounts surface_counts(std::size_t n_components, const NonmanifoldCounts& nonmanifold) {
  return {n_components, nonmanifold.edges, nonmanifold.vertices};
}

/// Parts of the input of which no vertex is left.
std::size_t count_vanished(const Parts& parts, const std::vector<Index>& vertex_map) {
  std::vector<bool> is_left(parts.count);
  for (std::size_t v = 0; v < vertex_map.size(); ++v) {
    if (vertex_map[v] != invalid_index) is_left[parts.part_of[v]] = true;
  }
  return static_cast<std::size_t>(std::count(is_left.begin(), is_left.end(), false));
}

/// Fills in how the surface hung together and does now.
void compare_surfaces(const IndexedMesh& input, const NonmanifoldCounts& before, TriangleComplex& complex,
                      const DecimateOptions& options, Decimation& out) {
  out.result.after =
      surface_counts(find_parts(out.mesh.positions.size(), out.mesh.faces).count, complex.count_nonmanifold());
  out.result.before = surface_counts(out.result.after.components, before);
  const bool is_manifold = before.edges == 0 && before.vertices == 0;
  if (options.pairs.threshold == 0 && options.topology == Topology::keep && is_manifold) return;  // parts stay parts
  const Parts parts = find_parts(input.positions.size(), input.faces);
  out.result.before.components = parts.count;
  out.result.n_vanished_components = count_vanished(parts, out.vertex_map);
}

}  // namespace

std::string_view to_string(StopReason reason) {
  switch (reason) {
    case StopReason::target:
      return "target";
    case StopReason::cost:
      return "cost";
    case StopReason::exhausted:
      return "exhausted";
    case StopReason::cancelled:
      return "cancelled";
  }
  return "";
}

namespace {

Decimation run(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
               DecimationHost* host) {
  check(target, options, mesh.positions.size());
  check(mesh);
  const DecimationState* const state = host ? host->state() : nullptr;
  const Frame frame = state ? state->frame : Frame::of_points(mesh.positions);
  const ThresholdPairs pairs = threshold_pairs(mesh, options);
  TriangleComplex complex(mesh.positions, mesh.faces, frame, options.threads);
  Restraints restraints;
  if (state) {
    for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
      complex.set_position(v, state->vertices[complex.origin(v)].position);
    }
  }
  std::unique_ptr<PairCost> cost;
  if (HostedCost* const hosted_cost = host ? host->cost() : nullptr) {
    cost = std::make_unique<HostCost>(complex, restraints, *hosted_cost);
  } else {
    cost = make_cost(complex, restraints, options, !pairs.pairs.empty());
  }
  cost->see_faces(options.threads);
  complex.connect(pairs.pairs, options.threads);
  cost->start(options.threads);
  if (state) cost->resume(*state);
  const NonmanifoldCounts before = complex.count_nonmanifold();
  const std::vector<VertexPair> features = all_feature_edges(mesh, options);
  restraints = Restraints(complex, locked_vertices(complex, options), features, options.feature_angle_deg,
                          options.feature_tolerance * bounds_of(mesh.positions).diagonal() * frame.scale);
  ContractionLoop loop(complex, restraints, *cost, options, target, frame, host);
  DecimateResult result = loop.run();
  result.n_degenerate_faces = complex.n_degenerate_faces();
  result.n_coincident_faces = complex.n_coincident_faces();
  result.threshold_pairs.considered = pairs.pairs.size();
  result.threshold_pairs.threshold = options.pairs.threshold;
  result.threshold_pairs.capped = pairs.capped;
  Decimation out = make_output(mesh, complex, frame, options.keep_quadrics ? cost.get() : nullptr);
  for (const auto& [a, b] : restraints.feature_edges(complex)) {
    const Index first = out.vertex_map[complex.origin(a)];
    const Index second = out.vertex_map[complex.origin(b)];
    out.feature_edges.push_back({std::min(first, second), std::max(first, second)});
  }
  std::sort(out.feature_edges.begin(), out.feature_edges.end());
  out.result = result;
  compare_surfaces(mesh, before, complex, options, out);
  return out;
}

}  // namespace

Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options) {
  return run(mesh, target, options, nullptr);
}

Decimation decimate(const IndexedMesh& mesh, const DecimateTarget& target, const DecimateOptions& options,
                    DecimationHost& host) {
  return run(mesh, target, options, &host);
}

}  // namespace whittle
