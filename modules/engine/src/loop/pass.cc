#include "loop/pass.hh"

#include <algorithm>
#include <utility>

#include "cost/make_cost.hh"
#include "host/host_cost.hh"

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

}  // namespace

Pass::Pass(PassInput& input, const DecimateOptions& options)
    : options_(options),
      host_(input.host),
      context_(input.context),
      complex_(input.surface.positions, input.surface.faces, input.surface.frame, options.threads) {
  const DecimationState* const state = host_ ? host_->state() : nullptr;
  if (state) begin_with(*state, complex_, input.cost_state);
  HostedCost* const hosted_cost = host_ ? host_->cost() : nullptr;
  if (hosted_cost ? hosted_cost->stays_at_vertices() : stays_at_vertices(options)) complex_.follow_positions();
  if (!input.frozen.empty()) complex_.freeze(input.frozen);
  if (hosted_cost) {
    cost_ = std::make_unique<HostCost>(complex_, restraints_, *hosted_cost);
  } else {
    cost_ = make_cost(complex_, restraints_, options, !input.threshold_pairs.empty());
  }
  complex_.connect(input.threshold_pairs, options.threads);
  const bool has_planes = !hosted_cost && cost_traits(options.effective_cost()).has_quadrics;
  restraints_ = Restraints(complex_, locked_vertices(complex_, input.locked, options.boundary),
                           input.lines ? *input.lines : FeatureLines{}, options.feature_angle_deg.value_or(180),
                           input.feature_tolerance, has_planes ? SeamHold::along : SeamHold::at_ends);
  cost_->start(std::move(input.cost_state), options.threads);
}

void Pass::start(const DecimateTarget& target, const Frame& frame) {
  loop_.emplace(complex_, restraints_, *cost_, options_, target, frame, host_, context_);
}

std::vector<Index> representatives(TriangleComplex& complex) {
  std::vector<Index> result(complex.n_vertex_slots(), invalid_index);
  for (Index v = 0; v < complex.n_vertex_slots(); ++v) {
    const Index r = complex.representative(v);
    if (complex.has_faces(r)) result[complex.origin(v)] = r;
  }
  return result;
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

}  // namespace whittle
