#include <algorithm>
#include <utility>

#include "cost/make_cost.hh"
#include "rounds/rounds.hh"

// What rounds know of the vertices before the first one.

namespace whittle {
namespace {

/// Tells vertices whose faces are one closed fan, all of one orientation.
class RingTest {
 public:
  explicit RingTest(std::size_t n_vertices) : steps_(n_vertices) {}

  /// \param star of v
  bool is_ring(Index v, std::span<const LinkEdge> star) {
    if (star.size() < 3) return false;
    for (const auto& [x, y] : star) steps_[x] = {v, y};
    // A walk over all faces from one to the next, without a way out and without a short cut.
    std::size_t n = 0;
    Index at = star.front().x;
    do {
      if (steps_[at].vertex != v) return false;
      at = steps_[at].next;
      ++n;
    } while (at != star.front().x && n < star.size());
    return at == star.front().x && n == star.size();
  }

 private:
  struct Step {
    Index vertex = invalid_index;  ///< that is walked around
    Index next = invalid_index;
  };
  std::vector<Step> steps_;  ///< per neighbour
};

}  // namespace

Rounds::Rounds(WorkingSurface& surface, const StageContext& context, RoundScratchPool& pool)
    : options_(context.options),
      quadric_(quadric_options(context.options)),
      frame_(context.frame),
      cost_unit_(context.frame.unscale, cost_dimension(context.options)),
      log_(context.log),
      flip_limit_(context.options.effective_max_normal_flip_deg()),
      face_area_(*surface.cost_state.face_area),
      displacement_(context.limits.displacement),
      displacements_(context.limits.displacements.begin(), context.limits.displacements.end()),
      pool_(pool),
      scratch_(pool.take()),
      mesh_(surface.positions, surface.faces, context.frozen, !context.areas.of.empty(), *scratch_),
      flags_(mesh_.n_vertices(), frozen),
      areas_(context.areas),
      valences_(mesh_, options_.valence_weight),
      states_(mesh_.n_vertices(), outdated),
      stars_(scratch_->stars_of(mesh_.n_vertices())),
      held_(mesh_.n_vertices()),
      pair_costs_(mesh_.points(), stars_, face_area_.first(), quadric_.placement),
      star_(mesh_) {
  surface.positions = {};
  sum_up();
  n_faces_ = mesh_.n_faces();
  n_degenerate_faces_ = surface.faces.size() - n_faces_;
  if (areas_.any()) {
    for (Index f = 0; f < surface.faces.size(); ++f) {
      if (has_three_corners(surface.faces[f])) areas_.add(f);
    }
  }
  look_at_vertices(context);
  take_over(surface.cost_state);
  SurfaceAttributes& attributes = surface.cost_state.attributes;
  if (attributes.wedges.any()) attributes_ = AttributeQuadrics(std::move(attributes), flags_.size());
}

void Rounds::look_at_vertices(const StageContext& context) {
  RingTest rings(flags_.size());
  Link link(flags_.size());
  n_inner_ = mesh_.vertices().size();
  for (const Index v : mesh_.vertices()) {
    const bool is_locked = !context.locked.empty() && context.locked[v] != 0;
    flags_[v] = is_locked ? locked : 0;
    const bool is_ring = rings.is_ring(v, mesh_.star(v));
    if (is_ring && valences_.count()) valences_.set(v, mesh_.star(v).size(), false);
    if (!is_ring) look_at_irregular(v, link, context.frozen);
    if (flags_[v] != 0) special_.push_back(v);
  }
}

/// A vertex that is no ring.
void Rounds::look_at_irregular(Index v, Link& link, std::span<const std::uint8_t> frozen_by_context) {
  const std::span<const LinkEdge> star = mesh_.star(v);
  link.gather(star);
  const VertexKind kind = link.kind();
  if (valences_.count()) valences_.set(v, link.entries().size(), kind != VertexKind::regular);
  if (kind != VertexKind::regular) {
    for (const Link::Entry& entry : link.entries()) {
      const bool is_seen_from_both = frozen_by_context.empty() || frozen_by_context[entry.vertex] == 0;
      const bool is_counted_here = !is_seen_from_both || v < entry.vertex;
      nonmanifold_.edges += static_cast<std::uint64_t>(entry.n_faces[0] > 2 && is_counted_here);
    }
    nonmanifold_.vertices += static_cast<std::uint64_t>(link.n_fans() > 1);
  }
  flags_[v] |= irregular;
  if (kind != VertexKind::regular && options_.boundary == Boundary::locked) flags_[v] |= locked;
  Quadric planes{stars_[v].matrix(), Vec3::Zero(), 0};
  if (quadric_.boundary_weight > 0 && kind != VertexKind::regular) planes.a += planes_of_borders(v);
  remembered_.set(v, planes, flags_.size());
}

SymmetricMatrix Rounds::planes_of_borders(Index v) const {
  const std::span<const LinkEdge> star = mesh_.star(v);
  const auto is_border = [&](Index w) {
    return std::count_if(star.begin(), star.end(), [w](const LinkEdge& f) { return f.x == w || f.y == w; }) == 1;
  };
  SymmetricMatrix sum;
  for (const auto& [x, y] : star) {
    if (is_border(x)) sum += border_quadric(mesh_.point(v), mesh_.point(x), mesh_.point(y), quadric_);
    if (is_border(y)) sum += border_quadric(mesh_.point(y), mesh_.point(v), mesh_.point(x), quadric_);
  }
  return sum;
}

/// Takes over what vertices remember from before.
void Rounds::take_over(const CostState& before) {
  for (const auto& [v, quadric] : before.seams) {
    if (has(v, frozen)) continue;
    if (const Quadric* const own = remembered_.find(v)) {
      Quadric sum = *own;
      sum += quadric;
      remembered_.set(v, sum, flags_.size());
      continue;
    }
    if (flags_[v] == 0) special_.push_back(v);
    flags_[v] |= on_seam;
    seams_.set(v, quadric, flags_.size());
  }
  for (const auto& [v, quadric] : before.quadrics) {
    if (has(v, frozen)) continue;
    if (flags_[v] == 0) special_.push_back(v);
    flags_[v] = static_cast<std::uint8_t>((flags_[v] | irregular) & ~on_seam);
    remembered_.set(v, quadric, flags_.size());
  }
}

}  // namespace whittle
