#include <algorithm>
#include <array>

#include "complex/fan_sorter.hh"
#include "cost/make_cost.hh"
#include "rounds/rounds.hh"

// What rounds know of the vertices before the first one.

namespace whittle {
namespace {

/// Whether the faces at a vertex are one closed fan, all of one orientation. False may only mean that a closer look is
/// due.
bool is_small_ring(std::span<const LinkEdge> star, FanSorter& sorter) {
  std::array<Neighbour, FanSorter::max_faces> faces;
  std::array<Index, FanSorter::max_faces> ring;
  const std::size_t n = star.size();
  if (n < 3 || n > faces.size()) return false;
  for (std::size_t i = 0; i < n; ++i) faces[i] = {star[i].x, star[i].y};
  return sorter.sort(std::span(faces.data(), n), ring);
}

/// Whether all faces of one fan have one orientation.
bool is_oriented(std::span<const LinkEdge> star) {
  return std::none_of(star.begin(), star.end(), [&](const LinkEdge& f) {
    return std::count_if(star.begin(), star.end(), [&](const LinkEdge& g) { return f.x == g.x || f.y == g.y; }) > 1;
  });
}

}  // namespace

Rounds::Rounds(WorkingSurface& surface, const StageContext& context, RoundScratchPool& pool)
    : options_(context.options),
      quadric_(quadric_options(context.options)),
      cost_unit_(context.frame.unscale, cost_dimension(context.options)),
      log_(context.log),
      flip_limit_(context.options.effective_max_normal_flip_deg()),
      face_area_(*surface.cost_state.face_area),
      pool_(pool),
      scratch_(pool.take()),
      mesh_(surface.positions, surface.faces, *scratch_),
      flags_(mesh_.n_vertices()),
      areas_(context.areas),
      states_(mesh_.n_vertices()),
      stars_(scratch_->stars_of(mesh_.n_vertices())),
      held_(mesh_.n_vertices()),
      pair_costs_(mesh_.points(), stars_, face_area_.first()),
      star_(mesh_) {
  surface.positions = {};
  sum_up();
  n_faces_ = mesh_.faces().size();
  n_degenerate_faces_ = surface.faces.size() - n_faces_;
  if (areas_.any()) {
    for (const Index f : mesh_.face_origins()) areas_.add(f);
  }
  look_at_vertices(context);
  take_over(surface.cost_state);
  std::erase_if(special_, [this](Index v) { return has(v, frozen); });
}

void Rounds::look_at_vertices(const StageContext& context) {
  FanSorter sorter;
  Link link(flags_.size());
  for (Index v = 0; v < flags_.size(); ++v) {
    const std::span<const LinkEdge> star = mesh_.star(v);
    const bool is_frozen = !context.frozen.empty() && context.frozen[v] != 0;
    if (star.empty() || is_frozen) {
      flags_[v] = frozen;
      n_frozen_ += static_cast<std::size_t>(!star.empty());
      continue;
    }
    ++n_inner_;
    if (!context.locked.empty() && context.locked[v] != 0) flags_[v] = locked;
    if (!is_small_ring(star, sorter)) look_at_irregular(v, link, context.frozen);
    if (flags_[v] != 0 && !has(v, frozen)) special_.push_back(v);
  }
}

/// A vertex that seems to be no ring.
void Rounds::look_at_irregular(Index v, Link& link, std::span<const std::uint8_t> frozen_by_context) {
  const std::span<const LinkEdge> star = mesh_.star(v);
  link.gather(star);
  const VertexKind kind = link.kind();
  const bool is_ring = kind == VertexKind::regular && link.is_oriented() && star.size() > 2;
  if (is_ring) return;
  if (kind != VertexKind::regular) {
    for (const Link::Entry& entry : link.entries()) {
      const bool is_seen_from_both = frozen_by_context.empty() || frozen_by_context[entry.vertex] == 0;
      const bool is_counted_here = !is_seen_from_both || v < entry.vertex;
      nonmanifold_.edges += static_cast<std::uint64_t>(entry.n_faces[0] > 2 && is_counted_here);
    }
    nonmanifold_.vertices += static_cast<std::uint64_t>(link.n_fans() > 1);
  }
  const bool is_on_border = kind == VertexKind::line && is_oriented(star);
  flags_[v] |= is_on_border ? on_border : frozen;
  if (is_on_border && options_.boundary == Boundary::locked) flags_[v] |= locked;
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

/// Takes over what vertices remember from before. One that needn't remember anything isn't as it was: it is left alone.
void Rounds::take_over(const CostState& before) {
  for (const auto& [v, quadric] : before.seams) {
    if (has(v, frozen) && !remembered_.contains(v)) continue;
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
    if (has(v, frozen) && !remembered_.contains(v)) continue;
    if (!remembered_.contains(v)) flags_[v] = frozen;
    remembered_.set(v, quadric, flags_.size());
  }
}

}  // namespace whittle
