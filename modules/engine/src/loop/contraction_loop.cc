#include "loop/contraction_loop.hh"

#include <algorithm>
#include <limits>

#include "cost/make_cost.hh"
#include "cost/vanishing_cost.hh"
#include "host/host_cost.hh"
#include "loop/make_guards.hh"
#include "loop/surface_of_faces.hh"
#include "queue/eager_queue.hh"
#include "queue/lazy_queue.hh"

namespace whittle {
namespace {

/// Turns between two calls of the progress callback: about a millisecond, also where several pairs have one turn.
constexpr std::uint64_t progress_interval = 2048;
constexpr std::uint64_t progress_interval_of_several = 1;

/// What a host's cost says of pairs that it refuses.
constexpr double never = std::numeric_limits<double>::infinity();

/// In the place of a guard's number.
constexpr RefusedPairs::Refuser refused_by_cost = 0xfe;
constexpr RefusedPairs::Refuser refused_for_error = 0xfd;
/// Of pairs in the queue at a cost above their rank, as faces would vanish, to be looked at again after changes nearby.
constexpr RefusedPairs::Refuser raised_for_faces = 0xfc;

/// Whether pairs stay where they were queued until their turn comes.
bool is_lazy(const PairRanks& ranks, const DecimateOptions& options) {
  return ranks.affects() == Reach::none || options.effective_order() == Order::approximate;
}

std::unique_ptr<PairQueue> make_queue(TriangleComplex& complex, const PairRanks& ranks, ThresholdPairFilter& filter,
                                      const RefusedPairs& refused, const UncertainVertices* uncertain,
                                      const DecimateOptions& options) {
  if (is_lazy(ranks, options)) {
    return std::make_unique<LazyQueue>(complex, ranks, filter, refused, uncertain, options.threads);
  }
  return std::make_unique<EagerQueue>(complex, ranks, options.threads);
}

std::optional<UncertainVertices> find_uncertain(const TriangleComplex& complex, Role role) {
  if (role != Role::in_exact_order) return std::nullopt;
  return UncertainVertices(complex);
}

/// An eager queue ranks anew all pairs that a contraction affects.
Reach reach_of_touched(const PairRanks& ranks, const DecimateOptions& options) {
  return is_lazy(ranks, options) ? ranks.reads() : std::max(ranks.affects(), ranks.reads());
}

}  // namespace

ContractionLoop::ContractionLoop(TriangleComplex& complex, Constraints& constraints, PairCost& cost,
                                 const DecimateTarget& target, std::span<const GuardedPair> refusals,
                                 const StageContext& context)
    : complex_(complex),
      constraints_(constraints),
      placer_(cost),
      options_(context.options),
      target_(target),
      frame_(context.frame),
      cost_dimension_(context.host && context.host->cost() ? context.host->cost()->dimension()
                                                           : cost_dimension(context.options)),
      cost_unit_(context.frame.unscale, cost_dimension_),
      host_(context.host),
      log_(context.log),
      n_initial_vertices_(complex.n_vertices()),
      n_initial_faces_(complex.n_faces()),
      filter_(complex),
      guards_(make_guards(complex, constraints, filter_, context)),
      at_once_(complex, context.limits, context.options.threads),
      uncertain_(find_uncertain(complex, context.role)),
      ranks_(complex, cost, host_ && host_->cost() ? 0 : options_.valence_weight),
      touched_(reach_of_touched(ranks_, options_)),
      refused_(complex) {
  for (const auto& guard : guards_) {
    n_rings_ = std::max(n_rings_, guard->n_rings());
    if (guard->follows()) followers_.push_back(guard.get());
  }
  begin_with(refusals);
  queue_ = make_queue(complex, ranks_, filter_, refused_, uncertain_ ? &*uncertain_ : nullptr, options_);
  if (const auto limit = target.cost_limit()) cost_limit_ = frame_.cost_to_frame(*limit, cost_dimension_);
}

void ContractionLoop::begin_with(std::span<const GuardedPair> refusals) {
  if (refusals.empty()) return;
  const std::vector<Index> vertices = complex_.vertices_by_origin();
  for (const GuardedPair& refusal : refusals) {
    const Index a = vertices[refusal.pair.a];
    const Index b = vertices[refusal.pair.b];
    const auto neighbours = complex_.neighbours(a);
    const auto edge =
        std::find_if(neighbours.begin(), neighbours.end(), [b](const Neighbour& n) { return n.vertex == b; });
    const auto guard =
        std::find_if(guards_.begin(), guards_.end(), [&](const auto& g) { return g->reason() == refusal.reason; });
    if (edge == neighbours.end() || guard == guards_.end()) continue;
    note_refusal(in_order(complex_, {edge->edge, a, b}), static_cast<std::size_t>(guard - guards_.begin()));
  }
}

/// Calls `use(pair, reason)` for each pair left that a guard refused.
template <class Use>
void ContractionLoop::for_each_refused(const Use& use) const {
  for (Index id = 0; id < complex_.n_pair_slots(); ++id) {
    if (!complex_.is_pair_alive(id)) continue;
    const RefusedPairs::Refuser refuser = refused_.refuser(id);
    if (refuser < guards_.size()) use(id, guards_[refuser]->reason());
    if (refuser == refused_for_error) use(id, Refusal::error);
  }
}

std::vector<GuardedPair> ContractionLoop::refusals() {
  std::vector<GuardedPair> refusals;
  for_each_refused([&](Index id, std::optional<Refusal> reason) {
    const auto [a, b] = complex_.ends(id);
    refusals.push_back({{complex_.origin(a), complex_.origin(b)}, reason});
  });
  return refusals;
}

DecimateResult ContractionLoop::run() {
  stop_.reset();
  const std::uint64_t interval = at_once_.any() ? progress_interval_of_several : progress_interval;
  for (std::uint64_t n_turns = 0; !stop_; ++n_turns) {
    if (target_reached()) {
      stop_ = StopReason::target;
    } else if (n_turns % interval == 0 && !report_progress()) {
      stop_ = StopReason::cancelled;
    } else if (!(at_once_.any() ? take_several() : take_next()) && !ask_guards_to_give_way()) {
      stop_ = StopReason::exhausted;
    }
  }
  result_.stop = *stop_;
  if (result_.stop == StopReason::exhausted) result_.refused_at_end = count_refused_pairs();
  result_.n_contractions = complex_.n_contractions();
  result_.n_vertices = complex_.n_vertices();
  result_.n_faces = complex_.n_faces();
  DecimateResult result = result_;
  result.max_cost = cost_unit_.times(result_.max_cost);
  return result;
}

bool ContractionLoop::target_reached() const {
  return target_.is_reached_at(complex_.n_faces(), complex_.n_vertices());
}

bool ContractionLoop::report_progress() const {
  if (!options_.progress) return true;
  const auto share = [](std::uint64_t initial, std::uint64_t now, std::optional<std::uint64_t> target) {
    if (!target || initial <= *target) return 0.0;
    return static_cast<double>(initial - now) / static_cast<double>(initial - *target);
  };
  const double faces = share(n_initial_faces_, complex_.n_faces(), target_.n_faces());
  const double vertices = share(n_initial_vertices_, complex_.n_vertices(), target_.n_vertices());
  return options_.progress({complex_.n_vertices(), complex_.n_faces(), std::min(1.0, std::max(faces, vertices)),
                            Stage::decimate, [this] { return surface_now(); }});
}

IndexedMesh ContractionLoop::surface_now() const {
  return surface_of_faces(complex_.live_faces(), complex_.n_vertex_slots(),
                          [this](Index v) { return frame_.to_model(complex_.position(v)); });
}

/// \return whether there was a pair
bool ContractionLoop::take_next() {
  const std::optional<RankedPair> ranked = queue_->next();
  if (ranked) take(*ranked);
  return ranked.has_value();
}

/// Contracts the pair, puts it off, leaves it to a later stage, refuses it, or stops because of its cost.
void ContractionLoop::take(const RankedPair& ranked) {
  if (!gather(ranked) || !find_places(ranked, 1)) return;
  const auto [position, survivor] = places_.front();
  if (const std::optional<double> cost = settle_cost(ranked, position)) contract(ranked, position, *cost);
}

/// The same with several pairs, but for those that are too near to others: these are queued again. \return as above
bool ContractionLoop::take_several() {
  constexpr std::size_t all_places = 8;
  at_once_.clear();
  put_off_.clear();
  bool is_any = false;
  while (!stop_ && !at_once_.is_full() && put_off_.size() <= at_once_.most()) {
    const std::optional<RankedPair> ranked = queue_->next();
    if (!ranked) break;
    is_any = true;
    if (!gather(*ranked)) continue;
    if (!at_once_.is_apart(profile_)) {
      put_off_.push_back(ranked->pair);
    } else if (find_places(*ranked, all_places) && settle_cost(*ranked, places_.front().position)) {
      at_once_.add(*ranked, profile_, places_);
    }
  }
  at_once_.look();
  for (PairsAtOnce::Entry& entry : at_once_.entries()) {
    if (!entry.is_accepted) find_nearer_places(entry);
  }
  at_once_.look();
  for (PairsAtOnce::Entry& entry : at_once_.entries()) finish(entry);
  for (const Pair& pair : put_off_) {
    if (complex_.is_pair_alive(pair.id)) queue_->add(pair_now(complex_, pair.id));
  }
  return is_any;
}

/// Contracts a pair that error guards have looked at, unless pairs before it have changed what a guard sees.
void ContractionLoop::finish(PairsAtOnce::Entry& entry) {
  const auto& [pair, rank] = entry.ranked;
  if (target_reached()) return queue_->add(pair);
  complex_.gather(pair, profile_);
  profile_.ranked = rank;
  if (!entry.is_accepted || !at_once_.still_accepts(entry)) return refuse_for_error(pair);
  if (const auto refuser = find_refusal()) return refuse(*refuser);
  placer_.place(profile_, rank);
  const auto [position, survivor] = entry.place();
  profile_.survivor = survivor;
  if (const auto refuser = find_refusal_at(position)) return refuse(*refuser);
  contract(entry.ranked, position, cost_at(position, rank));
  at_once_.note(change_, entry);
}

void ContractionLoop::refuse_for_error(const Pair& pair) {
  if (!is_refused(pair)) ++result_.refusals[Refusal::error];
  refused_.add(pair, refused_for_error);
}

/// Gathers the profile of a pair whose turn has come. \return whether it may be contracted
bool ContractionLoop::gather(const RankedPair& ranked) {
  if (!complex_.is_contractible(ranked.pair)) {
    complex_.remove_pair(ranked.pair.id);
    return false;
  }
  if (stop_at_cost(ranked.pair, ranked.rank.cost)) return false;
  if (!gather_if_certain(ranked.pair)) {
    leave_to_later(ranked.pair);
    return false;
  }
  profile_.ranked = ranked.rank;
  return true;
}

/// At least the rank.
double ContractionLoop::cost_at(const Vec3& position, const PairEvaluation& rank) const {
  const bool may_vanish = options_.topology == Topology::automatic;
  const double of_faces = may_vanish ? vanishing_cost(complex_, profile_, position, cost_dimension_) : 0;
  return std::max(rank.cost, placer_.final_cost(profile_, rank, position) + of_faces);
}

/// The cost at a position. nullopt if the pair isn't to be contracted now.
std::optional<double> ContractionLoop::settle_cost(const RankedPair& ranked, const Vec3& position) {
  const double cost = cost_at(position, ranked.rank);
  if (cost == never) {
    refused_.add(ranked.pair, refused_by_cost);
    return std::nullopt;
  }
  if (cost > ranked.rank.cost && queue_->postpone(ranked.pair, cost)) {
    const bool may_fall = profile_.is_nonmanifold && options_.effective_order() == Order::exact;
    if (may_fall) refused_.add(ranked.pair, raised_for_faces);
    return std::nullopt;
  }
  if (stop_at_cost(ranked.pair, cost)) return std::nullopt;
  return cost;
}

/// \return whether all that decides about the pair is known: it is manifold, and nothing around it is uncertain
bool ContractionLoop::gather_if_certain(const Pair& pair) {
  const auto& [id, a, b] = pair;
  const bool may_be_nonmanifold = !complex_.is_manifold(a) || !complex_.is_manifold(b);
  if (uncertain_ && (uncertain_->contains_any(pair) || may_be_nonmanifold)) return false;
  complex_.gather(pair, profile_);
  return !uncertain_ || !uncertain_->contains_any_around(profile_);
}

/// A stage that knows more may contract this pair now. So its ends become uncertain, and those of all pairs that this
/// may make contractible or cheaper.
void ContractionLoop::leave_to_later(const Pair& pair) {
  affected_.assign({pair.a, pair.b});
  while (!affected_.empty()) {
    const Index v = affected_.back();
    affected_.pop_back();
    if (uncertain_->contains(v)) continue;
    uncertain_->add(v);
    list_affected(v);
  }
}

/// Adds to `affected_` the ends of raised pairs at v, and of refused pairs at v and its neighbours.
void ContractionLoop::list_affected(Index v) {
  woken_.clear();
  queue_->list_raised(v, woken_);
  const auto list_refused = [&](Index w) { refused_.for_each_at(w, [&](Index id) { woken_.push_back(id); }); };
  list_refused(v);
  for (const Neighbour& neighbour : complex_.neighbours(v)) list_refused(complex_.representative(neighbour.vertex));
  for (const Index id : woken_) {
    if (!complex_.is_pair_alive(id)) continue;
    const auto [a, b] = complex_.ends(id);
    affected_.insert(affected_.end(), {a, b});
  }
}

/// Whether the pair costs more than may be. Then it is queued again, to go on from. One that is refused stops nothing.
bool ContractionLoop::stop_at_cost(const Pair& pair, double cost) {
  if (!cost_limit_ || !(cost > *cost_limit_) || cost == never) return false;
  stop_ = StopReason::cost;
  queue_->add(pair);
  return true;
}

/// Lists places that no guard refuses, up to `most`. Notes the refusal if there is none.
bool ContractionLoop::find_places(const RankedPair& ranked, std::size_t most) {
  places_.clear();
  if (const auto refuser = find_refusal()) {
    refuse(*refuser);
    return false;
  }
  // The higher origin survives, so that no pair's rank among ties moves forward. But a vertex that may not move
  // survives in any case.
  const Index survivor = constraints_.of(ranked.pair) == PairConstraint::first ? ranked.pair.a : ranked.pair.b;
  const CandidatePositions candidates = placer_.place(profile_, ranked.rank);
  std::optional<std::size_t> refusal;
  for (std::size_t i = 0; i < candidates.n && places_.size() < most; ++i) {
    const CandidatePositions::Option& option = candidates.options[i];
    profile_.survivor = option.survivor == invalid_index ? survivor : option.survivor;
    const std::optional<std::size_t> refusal_there = find_refusal_at(option.position);
    if (refusal_there) {
      refusal = refusal_there;
    } else {
      places_.push_back({option.position, profile_.survivor});
    }
  }
  if (!places_.empty()) {
    profile_.survivor = places_.front().survivor;
    return true;
  }
  if (refusal) {
    refuse(*refusal);
  } else {
    refused_.add(ranked.pair, refused_by_cost);  // by a host's cost, which counts it
  }
  return false;
}

/// Adds places nearer to the input to those of a pair, all of which error guards have refused.
void ContractionLoop::find_nearer_places(PairsAtOnce::Entry& entry) {
  if (!may_place_anywhere(entry.ranked.pair)) return;
  complex_.gather(entry.ranked.pair, profile_);
  profile_.ranked = entry.ranked.rank;
  profile_.survivor = entry.places.front().survivor;
  for (const Vec3& position : at_once_.nearer_positions(entry)) {
    if (!find_refusal_at(position)) entry.places.push_back({position, profile_.survivor});
  }
}

/// Whether the merged vertex may lie elsewhere than where the cost puts it.
bool ContractionLoop::may_place_anywhere(const Pair& pair) const {
  return places_anywhere(options_) && constraints_.of(pair) == PairConstraint::none;
}

/// The guard that refuses the pair wherever its merged vertex goes.
std::optional<std::size_t> ContractionLoop::find_refusal() {
  for (std::size_t i = 0; i < guards_.size(); ++i) {
    if (guards_[i]->refuses(profile_)) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> ContractionLoop::find_refusal_at(const Vec3& position) {
  for (std::size_t i = 0; i < guards_.size(); ++i) {
    if (guards_[i]->refuses_at(profile_, position)) return i;
  }
  return std::nullopt;
}

/// If so before its turn, it was queued twice.
bool ContractionLoop::is_refused(const Pair& pair) const {
  const RefusedPairs::Refuser refuser = refused_.refuser(pair.id);
  return refuser != RefusedPairs::none && refuser != raised_for_faces;
}

/// Notes that the guard of this number refused the pair.
void ContractionLoop::refuse(std::size_t guard) {
  if (!is_refused(profile_.pair)) guards_[guard]->count(result_.refusals);
  note_refusal(profile_.pair, guard);
}

void ContractionLoop::note_refusal(const Pair& pair, std::size_t guard) {
  const auto refuser = static_cast<RefusedPairs::Refuser>(guard);
  guards_[guard]->is_final() ? refused_.add_for_good(pair, refuser) : refused_.add(pair, refuser);
}

/// \return whether pairs were queued again
bool ContractionLoop::ask_guards_to_give_way() {
  std::vector<bool> gives_way;
  for (const auto& guard : guards_) gives_way.push_back(guard->gives_way());
  bool any = false;
  for (Index id = 0; id < complex_.n_pair_slots(); ++id) {
    const RefusedPairs::Refuser refuser = refused_.refuser(id);
    if (refuser >= guards_.size() || !gives_way[refuser] || !complex_.is_pair_alive(id)) continue;
    refused_.take_back(id);
    queue_->add(pair_now(complex_, id));
    any = true;
  }
  return any;
}

/// Each pair that is left counts once, for the guard that refused it last.
RefusalCounts ContractionLoop::count_refused_pairs() const {
  RefusalCounts counts;
  for_each_refused([&counts](Index, std::optional<Refusal> reason) {
    if (reason) ++counts[*reason];
  });
  return counts;
}

void ContractionLoop::contract(const RankedPair& ranked, const Vec3& position, double cost) {
  if (is_told()) told_ = hosted(complex_, profile_, ranked.rank, position);  // with the positions before
  complex_.contract(profile_, profile_.survivor, position, change_);
  result_.threshold_pairs.contracted += static_cast<std::uint64_t>(complex_.is_threshold_pair(ranked.pair.id));
  result_.max_cost = std::max(result_.max_cost, cost);
  if (is_told()) tell_others(*told_, cost);
  list_touched();
  placer_.merge(profile_, ranked.rank, change_);
  constraints_.note(complex_, profile_, change_);
  for (Guard* guard : followers_) guard->note(change_);
  queue_->note(change_);
  wake_around();
  filter_.merge(change_.survivor, change_.removed);
  if (!profile_.is_nonmanifold || profile_.nonmanifold.lost_edges.empty()) return;
  reveal_at(change_.survivor);
  for (const ContractionProfile::Common& neighbour : profile_.nonmanifold.common) reveal_at(neighbour.vertex);
}

/// Tells log, host and listener. A host may stop the run.
void ContractionLoop::tell_others(const HostedContraction& made, double cost) {
  Contraction contraction{made.survivor,
                          made.removed,
                          made.position,
                          cost_unit_.times(cost),
                          complex_.is_threshold_pair(profile_.pair.id),
                          profile_.is_nonmanifold && !profile_.nonmanifold.coincident.empty()};
  if (log_ != nullptr) log_->add(contraction);
  contraction.position = frame_.to_model(made.position);
  if (host_ != nullptr && !host_->follow(made, contraction)) stop_ = StopReason::cancelled;
  if (options_.listener) options_.listener(contraction);
}

}  // namespace whittle
