#include "rounds/rounds.hh"

#include <algorithm>
#include <array>
#include <utility>

#include "cost/make_cost.hh"
#include "guard/displacement_guard.hh"
#include "loop/contraction_log.hh"
#include "loop/surface_of_faces.hh"
#include "rounds/chunks.hh"
#include "whittle/core/geometry/radius_ratio.hh"

namespace whittle {
namespace {

/// A round that contracts less than this share of the vertices left isn't worth another.
constexpr double least_gain = 0.1;
constexpr std::uint64_t fewest_pairs = 16;
/// Turns between two calls of the progress callback: about a millisecond.
constexpr std::size_t turns_between_calls = 2048;

bool any_begins_with(Index v, std::span<const LinkEdge> star) {
  return std::any_of(star.begin(), star.end(), [v](const LinkEdge& face) { return face.x == v; });
}
bool any_ends_with(Index v, std::span<const LinkEdge> star) {
  return std::any_of(star.begin(), star.end(), [v](const LinkEdge& face) { return face.y == v; });
}

}  // namespace

void Rounds::run(double cost) {
  while (!is_cancelled_ && !is_target_reached()) {
    begin_round();
    const auto n_left = static_cast<double>(n_inner_ - n_contractions_);
    const auto n_pairs = std::max(fewest_pairs, static_cast<std::uint64_t>(share_of_large_round * n_left));
    const CostCounts* const counts = &cost_counts();
    RoundLimit limit = limits_of_parts({&counts, 1}, {n_pairs, slack_of_large_round}).front();
    const bool may_go_on = limit.cost < cost;
    if (!may_go_on) limit.cost = CostCounts::in_range(cost);
    const std::uint64_t n_before = n_contractions_;
    contract(limit);
    const auto n_done = static_cast<double>(n_contractions_ - n_before);
    const bool is_end_near = !may_go_on || displacement_;
    if (n_done == 0 || (is_end_near && n_done < least_gain * n_left)) return;
  }
}

void Rounds::begin_round() {
  if (std::exchange(has_begun_, true)) {
    mesh_.begin_round(options_.threads);
    sum_up();
  }
  held_.begin_round();
  list_pairs();
}

/// Sums up the planes of vertices whose faces have changed.
void Rounds::sum_up() {
  const std::span<const Index> vertices = mesh_.vertices();
  for_each_chunk(vertices.size(), options_.threads, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (const Index v : vertices.subspan(begin, end - begin)) {
      if (states_[v] == as_before) continue;
      stars_[v] = planes_of_star(v, mesh_.star(v), mesh_.points(), quadric_);
      states_[v] = as_before;
    }
  });
}

/// Pairs of vertices with flags come last.
void Rounds::list_pairs() {
  const std::span<const Index> vertices = mesh_.vertices();
  const std::size_t n_places = divide_places();
  std::vector<PairChunk>& chunks = scratch_->chunks;
  make_room(scratch_->pairs, n_places);
  make_room(scratch_->costs, n_places);
  for_each_chunk(vertices.size(), options_.threads, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    list_pairs_at(vertices.subspan(begin, end - begin), chunks[chunk]);
  });
  chunks.push_back({n_places, n_places});
  std::erase_if(special_, [this](Index v) { return mesh_.star(v).empty(); });
  for (const Index v : special_) list_pairs_at(v);
  scratch_->cost_counts.clear();
  for (const auto& [begin, end] : chunks) {
    scratch_->cost_counts.add(std::span(scratch_->costs).subspan(begin, end - begin));
  }
}

/// Gives each chunk of vertices places for its pairs. \return how many in all
std::size_t Rounds::divide_places() {
  const std::span<const Index> vertices = mesh_.vertices();
  scratch_->chunks.clear();
  std::size_t n_places = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i % chunk_length == 0) {
      ++n_places;  // the place after the last pair is written to
      scratch_->chunks.push_back({n_places, n_places});
    }
    n_places += mesh_.star(vertices[i]).size();
  }
  return n_places + 1;
}

/// Of vertices without flags, with others of them.
void Rounds::list_pairs_at(std::span<const Index> vertices, PairChunk& chunk) {
  const std::uint8_t* const flags = flags_.data();
  VertexPair* const first = scratch_->pairs.data() + chunk.begin;
  VertexPair* next = first;
  for (const Index v : vertices) {
    if (flags[v] != 0) continue;
    for (const LinkEdge& face : mesh_.star(v)) {
      const Index w = face.x;
      *next = {v, w};
      next += static_cast<std::ptrdiff_t>(v < w) & static_cast<std::ptrdiff_t>(flags[w] == 0);
    }
  }
  const std::span<const VertexPair> pairs(first, next);
  const auto costs = std::span(scratch_->costs).subspan(chunk.begin, pairs.size());
  attributes_.any() ? pair_costs_.rank(pairs, attributes_, costs) : pair_costs_.rank(pairs, costs);
  if (valences_.count()) penalize(pairs, costs);
  held_.raise(pairs, costs);
  chunk.end = chunk.begin + pairs.size();
}

void Rounds::penalize(std::span<const VertexPair> pairs, std::span<float> costs) const {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    costs[i] = CostCounts::in_range(valences_.penalized(pairs[i], costs[i]));
  }
}

/// Of a vertex with flags, all pairs but those that the other one lists, each once.
void Rounds::list_pairs_at(Index v) {
  const std::span<const LinkEdge> star = mesh_.star(v);
  const auto list = [&](Index w) {
    const bool is_listed_there = flags_[w] != 0 && w < v;
    if (has(w, frozen) || is_listed_there || (has(v, locked) && has(w, locked))) return;
    const VertexPair pair{std::min(v, w), std::max(v, w)};
    const float cost = held_.cost(pair, CostCounts::in_range(valences_.penalized(pair, rank(pair).cost)));
    std::size_t& place = scratch_->chunks.back().end;
    make_room(scratch_->pairs, place + 1);
    make_room(scratch_->costs, place + 1);
    scratch_->pairs[place] = pair;
    scratch_->costs[place++] = cost;
  };
  for (std::size_t i = 0; i < star.size(); ++i) {
    const auto [x, y] = star[i];
    if (!any_begins_with(x, star.first(i))) list(x);
    if (!any_begins_with(y, star) && !any_ends_with(y, star.first(i))) list(y);
  }
}

/// Lists the pairs that cost at most so much, by the class of their cost, and then as they are listed.
void Rounds::sort_candidates(float most) {
  const std::uint32_t first = std::min(cost_counts().first(), CostCounts::class_of(most));
  const std::uint32_t n = CostCounts::class_of(most) - first + 1;
  std::vector<Index>& places = scratch_->places;
  places.resize(n);
  Index sum = 0;
  for (std::uint32_t k = 0; k < n; ++k) {
    places[k] = sum;
    sum += cost_counts()[first + k];
  }
  n_candidates_ = sum;
  make_room(scratch_->candidates, sum);
  for (const auto& [begin, end] : scratch_->chunks) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t k = CostCounts::class_of(scratch_->costs[i]) - first;
      if (k < n) scratch_->candidates[places[k]++] = static_cast<Index>(i);
    }
  }
}

std::uint64_t Rounds::contract(const RoundLimit& limit) {
  sort_candidates(limit.cost);
  const std::uint64_t end = n_contractions_ + limit.n_pairs;
  std::uint64_t n_turns = 0;
  for (const Index i : std::span(scratch_->candidates).first(n_candidates_)) {
    if (n_contractions_ == end || is_target_reached()) break;
    const VertexPair& pair = scratch_->pairs[i];
    const bool is_taken = ((states_[pair.a] | states_[pair.b]) & taken) != 0;
    if (is_taken || scratch_->costs[i] > limit.cost) continue;
    if (n_turns++ % turns_between_calls == 0 && !goes_on()) break;
    take(pair, limit.cost);
  }
  return n_turns;
}

bool Rounds::is_target_reached() const { return target_.is_reached_at(n_faces_, n_vertices()); }

bool Rounds::goes_on() {
  if (!options_.progress) return true;
  is_cancelled_ = !options_.progress({n_vertices(), n_faces_, 0, Stage::decimate, [this] { return surface_now(); }});
  return !is_cancelled_;
}

/// \pre no vertex is frozen
IndexedMesh Rounds::surface_now() const {
  return surface_of_faces(mesh_.faces_now(), mesh_.n_vertices(),
                          [this](Index v) { return frame_.to_model(mesh_.point(v)); });
}

/// The turn of a pair.
void Rounds::take(const VertexPair& pair, float most) {
  const auto [a, b] = pair;
  if (!star_.gather(pair, {has(a, irregular), has(b, irregular)})) return refuse(pair, Refusal::link);
  refresh(a, 0);
  refresh(b, 1);
  const PairEvaluation ranked = rank(pair);
  double cost = valences_.penalized(pair, ranked.cost);
  if (CostCounts::in_range(cost) > most) return;
  if (areas_.any() && areas_.end_with(vanishing_faces(a))) return refuse(pair, Refusal::area);
  StarVolume volume;
  Vec3 position = ranked.position;
  const bool forgets_planes = forgets(pair);
  if (forgets_planes) {
    volume = star_.volume(stars_[a], stars_[b], ranked.position);
    if (ranked.is_minimum) position += volume_step(matrix(a) + matrix(b), volume);
  }
  if (const std::optional<Refusal> why = refusal_at(position)) {
    if (position == ranked.position) return refuse(pair, *why);
    position = ranked.position;
    if (const std::optional<Refusal> why_there = refusal_at(position)) return refuse(pair, *why_there);
  }
  if (displacement_ && moves_far(pair, position)) return held_.add_refused(pair, now());
  if (forgets_planes && volume.is_thin()) {
    cost = std::max(cost, thin_cost(star_.displacement_sq(position), face_area_.now(n_faces_)));
    const float in_range = CostCounts::in_range(cost);
    if (in_range > most) return held_.add_dear(pair, in_range, now());
  }
  merge(pair, ranked, position, cost);
}

/// Sums up the planes of a vertex of the pair, if its faces have changed in this round.
void Rounds::refresh(Index v, std::size_t end) {
  if ((states_[v] & outdated) == 0) return;
  states_[v] = as_before;
  stars_[v] = star_.planes(end, quadric_);
}

SymmetricMatrix Rounds::matrix(Index v) const { return flags_[v] == 0 ? stars_[v].matrix() : placed(v).quadric.a; }

PlacedQuadric Rounds::placed(Index v) const {
  if (const Quadric* const all = remembered_.find(v)) return {mesh_.point(v), *all};
  PlacedQuadric placed{mesh_.point(v), {stars_[v].matrix(), Vec3::Zero(), 0}};
  if (const Quadric* const seams = seams_.find(v)) placed.quadric += *seams;
  return placed;
}

PairEvaluation Rounds::rank(const VertexPair& pair) const {
  if (!is_special(pair) && !attributes_.any()) return pair_costs_.of(pair);
  const PairConstraint constraint = has(pair.a, locked)   ? PairConstraint::first
                                    : has(pair.b, locked) ? PairConstraint::second
                                                          : PairConstraint::none;
  const PlacedQuadric first = placed(pair.a);
  const PlacedQuadric second = placed(pair.b);
  return attributes_.any() ? pair_costs_.of(pair, first, second, attributes_, constraint)
                           : pair_costs_.of(first, second, constraint);
}

std::optional<Refusal> Rounds::refusal_at(const Vec3& position) {
  if (star_.exceeds(flip_limit_, position)) return Refusal::flip;
  if (options_.min_radius_ratio > 0 && makes_thin(position)) return Refusal::shape;
  return std::nullopt;
}

/// Whether a face gets a smaller radius ratio than allowed, that had a greater one.
bool Rounds::makes_thin(const Vec3& position) const {
  for (std::size_t i = 0; i < star_.n_faces(); ++i) {
    const Vec3 x = mesh_.point(star_.others(i).x);
    const Vec3 y = mesh_.point(star_.others(i).y);
    const double after = radius_ratio(position, x, y);
    if (after < *options_.min_radius_ratio && after < radius_ratio(mesh_.point(star_.apex(i)), x, y)) return true;
  }
  return false;
}

double Rounds::displacement_limit(const VertexPair& pair) const {
  return displacements_.empty() ? *displacement_ : std::min(displacements_[pair.a], displacements_[pair.b]);
}

/// Whether the pair that `star_` looks at moves the surface, or its border, too far (DisplacementGuard).
bool Rounds::moves_far(const VertexPair& pair, const Vec3& position) {
  const double limit = displacement_limit(pair);
  const double limit_sq = limit * limit;
  if (star_.displacement_sq(position) > limit_sq) return true;
  if (share_of_turn * share_of_turn * star_.turn_sq(position) > limit_sq) return true;
  if (!has(pair.a, irregular) && !has(pair.b, irregular)) return false;
  return border_motion_.exceeds(
      {pair.a, pair.b}, star_.stars(), [this](Index v) { return Vec3(mesh_.point(v)); }, position, limit);
}

/// Of the pair that `star_` looks at, by their numbers at the start.
std::span<const Index> Rounds::vanishing_faces(Index a) {
  const std::span<const Index> slots = star_.vanishing();
  vanishing_.clear();
  for (const Index slot : slots) vanishing_.push_back(mesh_.faces_in_star(a)[slot]);
  return vanishing_;
}

/// A locked vertex, or one that stays where it is.
Index Rounds::survivor(const VertexPair& pair, const Vec3& position) const {
  const auto [a, b] = pair;
  if (has(a, locked)) return a;
  const bool is_at_first = quadric_.placement == Placement::endpoint && position == Vec3(mesh_.point(a));
  return is_at_first && !has(b, locked) ? a : b;
}

void Rounds::merge(const VertexPair& pair, const PairEvaluation& ranked, const Vec3& position, double cost) {
  const auto [a, b] = pair;
  const Index survivor = this->survivor(pair, position);
  const Index removed = survivor == a ? b : a;
  if (areas_.any()) areas_.remove(vanishing_faces(a));
  valences_.merge(pair, survivor, star_.opposites());
  ++n_contractions_;
  for (std::size_t i = 0; i < star_.n_faces(); ++i) {
    note_change(star_.others(i).x);
    note_change(star_.others(i).y);
  }
  for (const Index v : star_.opposites()) note_change(v);
  for (const Index v : {a, b}) note_change(v);
  states_[a] = states_[b] = taken;
  if (!displacements_.empty()) displacements_[survivor] = displacement_limit(pair);
  if (attributes_.any() || is_special(pair)) merge_knowledge(pair, survivor, removed, ranked, position);
  mesh_.merge(pair, removed, position, star_.others());
  n_faces_ -= star_.opposites().size();
  max_cost_ = std::max(max_cost_, cost);
  if (log_ != nullptr) log_->add({survivor, removed, position, cost_unit_.times(cost), false, false});
}

/// What the merged vertex knows besides its faces.
void Rounds::merge_knowledge(const VertexPair& pair, Index survivor, Index removed, const PairEvaluation& ranked,
                             const Vec3& position) {
  const auto [a, b] = pair;
  Change change;
  change.pair = {invalid_index, a, b};
  change.survivor = survivor;
  change.removed = removed;
  change.before = {mesh_.point(a), mesh_.point(b)};
  change.position = position;
  if (attributes_.any()) attributes_.merge(change, true);
  if (!is_special(pair)) return;
  const std::uint8_t flags = flags_[a] | flags_[b];
  if ((flags & irregular) != 0) {
    const bool has_no_slope = ranked.is_minimum && !attributes_.any();
    remembered_.set(survivor, merged(placed(a), placed(b), position, has_no_slope).quadric, flags_.size());
    seams_.erase(survivor);
  } else if ((flags & on_seam) != 0) {
    seams_.merge(change);
  }
  if (flags_[survivor] == 0) special_.push_back(survivor);
  flags_[survivor] = (flags & irregular) != 0 ? static_cast<std::uint8_t>(flags & ~on_seam) : flags;
  remembered_.erase(removed);
  seams_.erase(removed);
}

DecimateResult Rounds::result() const {
  DecimateResult result;
  result.n_contractions = n_contractions_;
  result.n_vertices = n_vertices();
  result.n_faces = n_faces_;
  result.max_cost = cost_unit_.times(max_cost_);
  result.refusals = refusals_;
  result.n_degenerate_faces = n_degenerate_faces_;
  result.stop = is_cancelled_ ? StopReason::cancelled : is_target_reached() ? StopReason::target : StopReason::cost;
  return result;
}

CostState Rounds::state(std::span<const Index> vertices) const {
  CostState state;
  for (Index i = 0; i < vertices.size(); ++i) {
    const Index v = vertices[i];
    if (const Quadric* const all = remembered_.find(v)) state.quadrics.push_back({i, *all});
    if (const Quadric* const seams = seams_.find(v)) state.seams.push_back({i, *seams});
  }
  state.attributes = attributes_.at(vertices);
  return state;
}

}  // namespace whittle
