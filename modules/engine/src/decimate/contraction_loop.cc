#include "decimate/contraction_loop.hh"

#include <algorithm>

#include "cost/edge_length/isotropic_cost.hh"
#include "cost/edge_length/midpoint_cost.hh"
#include "cost/lindstrom_turk/lindstrom_turk_cost.hh"
#include "cost/memoryless/memoryless_cost.hh"
#include "cost/quadric/quadric_cost.hh"
#include "cost/valence/valence_cost.hh"
#include "guard/turned_faces.hh"
#include "queue/eager_order.hh"
#include "queue/lazy_order.hh"
#include "whittle/core/geometry/radius_ratio.hh"

namespace whittle {

namespace {

/// Turns between two calls of the progress callback: about a millisecond.
constexpr std::uint64_t progress_interval = 2048;

std::unique_ptr<PairCost> make_plain_cost(TriangleComplex& complex, const Restraints& restraints,
                                          const DecimateOptions& options) {
  switch (options.cost) {
    case Cost::lindstrom_turk:
      return std::make_unique<LindstromTurkCost>(complex, restraints, options.threads);
    case Cost::memoryless:
      return std::make_unique<MemorylessCost>(complex, restraints, options.quadric);
    case Cost::midpoint:
      return std::make_unique<MidpointCost>(complex, restraints);
    case Cost::quadric:
      break;
  }
  if (options.isotropy > 0) {
    return std::make_unique<IsotropicCost>(complex, restraints, options.quadric, options.isotropy);
  }
  return std::make_unique<QuadricCost>(complex, restraints, options.quadric);
}

std::unique_ptr<PairCost> make_cost(TriangleComplex& complex, const Restraints& restraints,
                                    const DecimateOptions& options) {
  std::unique_ptr<PairCost> cost = make_plain_cost(complex, restraints, options);
  if (options.valence_weight == 0) return cost;
  return std::make_unique<ValenceCost>(complex, std::move(cost), options.valence_weight);
}

/// Whether pairs stay where they were queued until their turn comes.
bool is_lazy(const PairCost& cost, const DecimateOptions& options) {
  if (cost.reach() == Reach::none || options.order == Order::approximate) return true;
  return options.order == Order::automatic && options.cost == Cost::memoryless;
}

std::unique_ptr<PairOrder> make_order(TriangleComplex& complex, const PairCost& cost, ThresholdPairSieve& sieve,
                                      const DecimateOptions& options) {
  if (is_lazy(cost, options)) return std::make_unique<LazyOrder>(complex, cost, sieve, options.threads);
  return std::make_unique<EagerOrder>(complex, cost, options.threads);
}

}  // namespace

ContractionLoop::ContractionLoop(TriangleComplex& complex, const DecimateOptions& options, const DecimateTarget& target,
                                 const Frame& frame, Restraints restraints)
    : complex_(complex),
      options_(options),
      target_(target),
      frame_(frame),
      restraints_(std::move(restraints)),
      sharp_edges_(complex, restraints_, options.feature_angle_deg),
      flip_limit_(options.max_normal_flip_deg),
      n_initial_vertices_(complex.n_vertices()),
      n_initial_faces_(complex.n_faces()),
      sieve_(complex),
      cost_(make_cost(complex, restraints_, options)),
      order_(make_order(complex, *cost_, sieve_, options)),
      listed_(is_lazy(*cost_, options) ? cost_->sight() : std::max(cost_->reach(), cost_->sight())),
      refused_(complex.n_vertex_slots()),
      is_refused_(complex.n_pair_slots()) {
  if (target.max_cost) target_.max_cost = frame.cost_to_frame(*target.max_cost, cost_->dimension());
}

DecimateResult ContractionLoop::run() {
  std::optional<StopReason> stop;
  for (std::uint64_t n_turns = 0; !stop; ++n_turns) {
    if (target_reached()) {
      stop = StopReason::target;
    } else if (n_turns % progress_interval == 0 && !report_progress()) {
      stop = StopReason::cancelled;
    } else if (const std::optional<Turn> turn = order_->next()) {
      stop = take(*turn);
    } else {
      stop = StopReason::exhausted;
    }
  }
  result_.stop = *stop;
  result_.n_contractions = complex_.n_contractions();
  result_.n_vertices = complex_.n_vertices();
  result_.n_faces = complex_.n_faces();
  result_.max_cost = frame_.cost_to_model(result_.max_cost, cost_->dimension());
  return result_;
}

bool ContractionLoop::target_reached() const {
  const DecimateTarget& target = target_;
  return (target.faces && complex_.n_faces() <= *target.faces) ||
         (target.vertices && complex_.n_vertices() <= *target.vertices);
}

bool ContractionLoop::report_progress() const {
  if (!options_.progress) return true;
  const auto share = [](std::uint64_t initial, std::uint64_t now, std::optional<std::uint64_t> target) {
    if (!target || initial <= *target) return 0.0;
    return static_cast<double>(initial - now) / static_cast<double>(initial - *target);
  };
  const double faces = share(n_initial_faces_, complex_.n_faces(), target_.faces);
  const double vertices = share(n_initial_vertices_, complex_.n_vertices(), target_.vertices);
  return options_.progress({complex_.n_vertices(), complex_.n_faces(), std::min(1.0, std::max(faces, vertices))});
}

std::optional<StopReason> ContractionLoop::take(Turn turn) {
  if (!complex_.is_contractible(turn.pair)) {
    complex_.remove_pair(turn.pair.id);
    return std::nullopt;
  }
  if (target_.max_cost && turn.evaluation.cost > *target_.max_cost) return StopReason::cost;
  if (const Refusal refusal = place(turn); refusal != Refusal::none) {
    refuse(turn.pair, refusal);
    return std::nullopt;
  }
  if (const double cost = cost_->final_cost(turn.evaluation); cost > turn.evaluation.cost) {
    if (order_->postpone(turn.pair, cost)) return std::nullopt;
    if (target_.max_cost && cost > *target_.max_cost) return StopReason::cost;
    turn.evaluation.cost = cost;
  }
  contract(turn);
  return std::nullopt;
}

/// Where the cost is least is second best, if the best place is refused.
ContractionLoop::Refusal ContractionLoop::place(Turn& turn) {
  const Pair& pair = turn.pair;
  if (!restraints_.pinned(pair)) return restraints_.are_both_locked(pair) ? Refusal::locked : Refusal::feature;
  complex_.gather(pair.a, pair.b, star_);
  const Refusal refusal = find_topological_refusal(pair);
  if (refusal != Refusal::none) return refusal;
  const Vec3 best = cost_->place(pair, turn.evaluation, star_);
  if (best != turn.evaluation.position && find_refusal_of(best, pair) == Refusal::none) {
    turn.evaluation.position = best;
    return Refusal::none;
  }
  return find_refusal_of(turn.evaluation.position, pair);
}

ContractionLoop::Refusal ContractionLoop::find_refusal_of(const Vec3& position, const Pair& pair) {
  const auto [id, a, b] = pair;
  if (restraints_.bends_a_line(complex_, pair, star_, position)) return Refusal::feature;
  if (turns_a_face(position, pair)) return Refusal::flip;
  if (sharp_edges_.would_change(pair, star_, position)) return Refusal::feature;
  if (makes_thin(star_.first, complex_.position(a), position)) return Refusal::shape;
  if (makes_thin(star_.second, complex_.position(b), position)) return Refusal::shape;
  return Refusal::none;
}

bool ContractionLoop::turns_a_face(const Vec3& position, const Pair& pair) {
  if (const std::optional<bool> answer = cost_->turns_a_face(position, flip_limit_)) return *answer;
  return whittle::turns_a_face(complex_, flip_limit_, star_.first, complex_.position(pair.a), position) ||
         whittle::turns_a_face(complex_, flip_limit_, star_.second, complex_.position(pair.b), position);
}

/// Whether moving the common corner of `wings` leaves one of them thinner than allowed, and than it was.
bool ContractionLoop::makes_thin(const Wings& wings, const Vec3& from, const Vec3& to) const {
  if (options_.min_radius_ratio == 0) return false;
  for (std::size_t i = 0; i < wings.size(); ++i) {
    const Vec3& x = complex_.position(wings[i].x);
    const Vec3& y = complex_.position(wings[i].y);
    const double after = radius_ratio(to, x, y);
    if (after < options_.min_radius_ratio && after < radius_ratio(from, x, y)) return true;
  }
  return false;
}

/// Plans a joint where the contraction may change the topology, and does; hides a threshold pair that an edge decides.
ContractionLoop::Refusal ContractionLoop::find_topological_refusal(const Pair& pair) {
  if (complex_.is_threshold_pair(pair.id)) {
    if (sieve_.hides(pair)) return Refusal::is_edge;
  } else if (complex_.link_condition(pair.a, pair.b, star_)) {
    return Refusal::none;
  } else if (options_.topology == Topology::keep && complex_.is_manifold(pair.a) && complex_.is_manifold(pair.b)) {
    return Refusal::link;
  }
  complex_.plan_joint(pair.a, pair.b, star_);
  if (star_.opposites.size() + star_.joint.coincident.size() == complex_.n_faces()) return Refusal::link;
  const bool may_change = complex_.is_threshold_pair(pair.id) || options_.topology == Topology::free;
  return may_change || complex_.is_no_less_manifold(pair.a, pair.b, star_) ? Refusal::none : Refusal::link;
}

void ContractionLoop::refuse(const Pair& pair, Refusal refusal) {
  switch (refusal) {
    case Refusal::locked:
      ++result_.rejections.locked;
      return;  // for good
    case Refusal::feature:
      ++result_.rejections.feature;
      break;
    case Refusal::link:
      ++result_.rejections.link;
      break;
    case Refusal::flip:
      ++result_.rejections.flip;
      break;
    case Refusal::shape:
      ++result_.rejections.shape;
      break;
    case Refusal::is_edge:  // hidden
    case Refusal::none:
      return;
  }
  const auto [id, a, b] = pair;
  if (is_refused_[id]) return;
  is_refused_[id] = true;
  refused_.add(a, id);
  refused_.add(b, id);
}

void ContractionLoop::contract(const Turn& turn) {
  const auto& [pair, evaluation] = turn;
  const PlacedQuadric merged = cost_->merge(pair, evaluation, star_);
  // The higher origin survives, so that no pair's place among ties moves forward; but a vertex that stays where it is
  // stays what it is.
  Index survivor = pair.b;
  Index removed = pair.a;
  if (restraints_.pinned(pair) == Pinned::first) {
    std::swap(survivor, removed);
  } else {
    std::swap(star_.first, star_.second);
  }
  restraints_.contract(complex_, pair, survivor, star_, evaluation.position);
  complex_.contract(pair.id, survivor, removed, merged, star_);
  result_.threshold_pairs.contracted += static_cast<std::uint64_t>(complex_.is_threshold_pair(pair.id));
  result_.max_cost = std::max(result_.max_cost, evaluation.cost);
  if (options_.listener) {
    options_.listener({complex_.origin(survivor), complex_.origin(removed), frame_.to_model(evaluation.position),
                       frame_.cost_to_model(evaluation.cost, cost_->dimension())});
  }
  list_changed(survivor);
  cost_->note_contraction(changed_);
  order_->note_contraction(survivor, removed, changed_);
  wake_refused_around(survivor, removed);
  sieve_.merge(survivor, removed);
  if (!star_.is_joint || star_.joint.lost_edges.empty()) return;
  reveal_at(survivor);
  for (const PairStar::Opposite& neighbour : star_.joint.common) reveal_at(neighbour.vertex);
}

/// Makes the lists of the vertices around the merged one what they are now.
void ContractionLoop::list_changed(Index survivor) {
  changed_.clear();
  if (listed_ == Reach::none) return;
  const auto add = [this](Index v) {
    v = complex_.representative(v);
    if (std::find(changed_.begin(), changed_.end(), v) == changed_.end()) changed_.push_back(v);
  };
  const auto add_neighbours = [&](Index v) {
    for (const Spoke& spoke : complex_.neighbours(v)) add(spoke.vertex);
  };
  add(survivor);
  if (listed_ >= Reach::ring) {
    add_neighbours(survivor);
    for (const PairStar::Opposite& opposite : star_.opposites) add(opposite.vertex);
    if (star_.is_joint) {
      for (const PairStar::Opposite& neighbour : star_.joint.common) add(neighbour.vertex);
    }
  }
  for (const Index v : changed_) complex_.tidy(v);
  if (listed_ < Reach::wings) return;
  for (const PairStar::Opposite& opposite : star_.opposites) add_neighbours(opposite.vertex);
  if (!star_.is_joint) return;
  for (const PairStar::Opposite& neighbour : star_.joint.common) add_neighbours(neighbour.vertex);
}

void ContractionLoop::wake_refused_around(Index survivor, Index removed) {
  const auto wake = [&](Index v) {
    if (refused_.any_at(v)) wake_refused_at(v);
  };
  const auto wake_neighbours = [&](Index v) {
    for (const Spoke& spoke : complex_.neighbours(v)) wake(spoke.vertex);
  };
  if (sharp_edges_.is_on()) {  // it looks a face farther
    for (const Spoke& spoke : complex_.neighbours(survivor)) {
      for (const Spoke& beyond : complex_.neighbours(spoke.vertex)) wake(complex_.representative(beyond.vertex));
    }
  }
  wake(survivor);
  wake(removed);
  wake_neighbours(survivor);
  for (const PairStar::Opposite& opposite : star_.opposites) wake(opposite.vertex);
  if (!star_.is_joint) return;
  for (const PairStar::Opposite& neighbour : star_.joint.common) {  // their faces hang together in another way now
    wake(neighbour.vertex);
    wake_neighbours(neighbour.vertex);
  }
}

void ContractionLoop::wake_refused_at(Index v) {
  woken_.clear();
  refused_.take(v, woken_);
  for (const Index pair : woken_) {
    if (!is_refused_[pair]) continue;  // woken from its other vertex before
    is_refused_[pair] = false;
    if (complex_.is_pair_alive(pair)) order_->add(pair_now(complex_, pair));
  }
}

/// Queues anew those pairs hidden at v that have lost their common faces.
void ContractionLoop::reveal_at(Index v) {
  woken_.clear();
  sieve_.reveal(v, woken_);
  for (const Index id : woken_) {
    if (!complex_.is_pair_alive(id)) continue;
    const Pair pair = pair_now(complex_, id);
    if (complex_.is_contractible(pair) && !sieve_.hides(pair)) order_->add(pair);
  }
}

}  // namespace whittle
