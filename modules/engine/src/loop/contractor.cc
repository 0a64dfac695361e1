#include "loop/contractor.hh"

#include <algorithm>
#include <utility>

#include "cost/make_cost.hh"
#include "host/host_cost.hh"
#include "whittle/core/detail/large_array.hh"

namespace whittle {
namespace {

/// Whether each vertex of the result lies at one of the input.
bool stays_at_vertices(const DecimateOptions& options) {
  return cost_traits(options.effective_cost()).has_quadrics && options.quadric.placement == Placement::endpoint;
}

/// Per vertex of the complex; empty if none is. \param by_user by number in the input, or empty
std::vector<std::uint8_t> locked_vertices(const TriangleComplex& complex, std::span<const std::uint8_t> by_user,
                                          Boundary boundary) {
  std::vector<std::uint8_t> locked;
  if (by_user.empty() && boundary != Boundary::locked) return locked;
  locked.resize(complex.n_vertex_slots());
  for (Index v = 0; v < locked.size(); ++v) {
    const bool is_border = boundary == Boundary::locked && complex.kind(v) != VertexKind::regular;
    locked[v] = is_border || (!by_user.empty() && by_user[complex.origin(v)] != 0);
  }
  return locked;
}

/// Drops from `faces` those that the complex no longer has. Of several coincident ones the first are kept.
void leave_out_coincident(std::vector<Index>& faces, std::span<const Triangle> input,
                          const std::vector<Index>& representatives, TriangleComplex& complex) {
  const std::vector<Triangle> live = complex.live_faces();
  std::vector<bool> is_found(live.size());
  std::erase_if(faces, [&](Index f) {
    Triangle face = mapped(input[f], representatives);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    const auto [begin, end] = std::equal_range(live.begin(), live.end(), face);
    for (auto it = begin; it != end; ++it) {
      const auto slot = static_cast<std::size_t>(it - live.begin());
      if (is_found[slot]) continue;
      is_found[slot] = true;
      return false;
    }
    return true;
  });
}

/// Where each vertex of the surface went, as a vertex of the complex; `invalid_index` for those without a face.
std::vector<Index> representatives(TriangleComplex& complex) {
  std::vector<Index> result(complex.n_vertex_slots(), invalid_index);
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    const Index r = complex.representative(v);
    if (complex.has_faces(r)) result[complex.origin(v)] = r;
  }
  return result;
}

/// The vertices of the complex that are left, by their numbers in the surface.
/// \param went_to vertices of the surface → vertices of the complex
std::vector<Index> vertices_left(const TriangleComplex& complex, const std::vector<Index>& went_to) {
  std::vector<Index> vertices;
  reserve_large(vertices, complex.n_vertices());
  for (Index i = 0; i < went_to.size(); ++i) {
    if (went_to[i] != invalid_index && complex.identity(went_to[i]) == i) vertices.push_back(went_to[i]);
  }
  return vertices;
}

/// Those that an edge decides are left out: their vertices share a face.
std::vector<VertexPair> threshold_pairs_left(TriangleComplex& complex, const std::vector<Index>& numbers) {
  std::vector<VertexPair> pairs;
  for (auto id = static_cast<Index>(complex.n_edges()); id < complex.n_pair_slots(); ++id) {
    if (!complex.is_pair_alive(id)) continue;
    const auto [a, b] = complex.ends(id);
    if (!complex.is_contractible({id, a, b}) || complex.have_common_face(a, b)) continue;
    const auto [low, high] = std::minmax(numbers[a], numbers[b]);
    pairs.push_back({low, high});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

Contractor::Contractor(WorkingSurface& surface, const StageContext& context)
    : context_(context),
      complex_(surface.positions, surface.faces, surface.frame, context.options.threads),
      refusals_before_(std::move(surface.refusals)) {
  surface.positions = {};
  const DecimateOptions& options = context.options;
  HostedCost* const hosted_cost = context.host ? context.host->cost() : nullptr;
  if (hosted_cost ? hosted_cost->stays_at_vertices() : stays_at_vertices(options)) complex_.follow_positions();
  if (!context.frozen.empty()) complex_.freeze(context.frozen);
  if (hosted_cost) {
    cost_ = std::make_unique<HostCost>(complex_, constraints_, *hosted_cost);
  } else {
    cost_ = make_cost(complex_, constraints_, options, !surface.threshold_pairs.empty());
  }
  complex_.connect(surface.threshold_pairs, options.threads);
  surface.threshold_pairs = {};
  const bool has_planes = !hosted_cost && cost_traits(options.effective_cost()).has_quadrics;
  constraints_ = Constraints(complex_, locked_vertices(complex_, context.locked, options.boundary), surface.lines,
                             options.feature_angle_deg.value_or(180), context.feature_tolerance,
                             has_planes ? SeamHold::along : SeamHold::at_ends);
  cost_->start(std::move(surface.cost_state), options.threads);
}

void Contractor::start(const DecimateTarget& target) {
  loop_.emplace(complex_, constraints_, *cost_, target, refusals_before_, context_);
}

std::vector<Index> surviving_faces(std::span<const Triangle> faces, const std::vector<Index>& representatives,
                                   TriangleComplex& complex) {
  std::vector<Index> result;
  reserve_large(result, complex.n_faces());
  for (Index f = 0; f < faces.size(); ++f) {
    if (has_three_corners(mapped(faces[f], representatives))) result.push_back(f);
  }
  if (complex.n_coincident_faces() > 0) leave_out_coincident(result, faces, representatives, complex);
  return result;
}

void Contractor::write_back(WorkingSurface& surface, bool goes_on) {
  std::vector<Index> went_to = representatives(complex_);
  const std::vector<Index> vertices = vertices_left(complex_, went_to);
  std::vector<Index> numbers(complex_.n_vertex_slots(), invalid_index);
  WorkingSurface left;
  reserve_large(left.positions.own(), vertices.size());
  reserve_large(left.origins, vertices.size());
  for (const Index v : vertices) {
    numbers[v] = static_cast<Index>(left.origins.size());
    left.positions.own().push_back(complex_.position(v));
    left.origins.push_back(surface.origin_of(complex_.identity(v)));
  }
  const std::span<const Triangle> faces = surface.faces;
  left.face_origins = surviving_faces(faces, went_to, complex_);
  for (Index& v : went_to) {
    if (v != invalid_index) v = numbers[v];
  }
  reserve_large(left.faces.own(), left.face_origins.size());
  for (Index& f : left.face_origins) {
    left.faces.own().push_back(mapped(faces[f], went_to));
    f = surface.face_origin_of(f);
  }
  if (surface.is_input()) {
    left.vertex_map = std::move(went_to);
  } else {
    reserve_large(left.vertex_map, surface.vertex_map.size());
    for (const Index v : surface.vertex_map) left.vertex_map.push_back(v == invalid_index ? v : went_to[v]);
  }
  left.lines = constraints_.lines(complex_, numbers);
  if (context_.options.keep_quadrics) {
    reserve_large(left.quadrics, vertices.size());
    for (const Index v : vertices) left.quadrics.push_back({complex_.position(v), cost_->quadric(v)});
  }
  if (goes_on) {
    left.cost_state = cost_->state(vertices);
    left.threshold_pairs = threshold_pairs_left(complex_, numbers);
  }
  surface = std::move(left);
}

}  // namespace whittle
