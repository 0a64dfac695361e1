#include "contraction_loop.hh"

#include <algorithm>
#include <array>

#include "level_pairs.hh"
#include "turned_faces.hh"
#include "whittle/engine/parallel.hh"
#include "whittle/engine/select.hh"

namespace whittle {

namespace {

/// Candidates between two calls of the progress callback: about a millisecond.
constexpr std::uint64_t progress_interval = 2048;

/// Members of a bucket from which on they are shared out among threads: some tens of microseconds.
constexpr std::size_t fewest_shared = 256;

/// Parcels that are shared out at a time. On flat ground all pairs may be in one bucket.
constexpr std::size_t n_shared_parcels = 64;

/// Candidates whose placements are remembered.
constexpr std::size_t most_placements = 8192;

}  // namespace

ContractionLoop::ContractionLoop(TriangleComplex& complex, const DecimateOptions& options, LoopSettings settings)
    : complex_(complex),
      options_(options),
      settings_(std::move(settings)),
      flip_limit_(options.max_normal_flip_deg),
      cost_times_area_(options.quadric.weights != Weights::uniform),
      crew_(options.threads),
      n_initial_vertices_(complex.n_vertices()),
      n_initial_faces_(complex.n_faces()),
      parcels_(crew_.n_helpers() == 0 ? 2 : n_shared_parcels),
      raised_(complex.n_vertex_slots()),
      is_raised_(complex.n_pair_slots()),
      raised_costs_(std::make_unique_for_overwrite<float[]>(complex.n_pair_slots())),
      refused_(complex.n_vertex_slots()),
      is_refused_(complex.n_pair_slots()),
      sieve_(complex) {}

DecimateResult ContractionLoop::run() {
  fill_queue();
  std::optional<StopReason> stop;
  for (std::uint64_t n_turns = 0; !stop; ++n_turns) {
    if (target_reached()) {
      stop = StopReason::target;
    } else if (n_turns % progress_interval == 0 && !report_progress()) {
      stop = StopReason::cancelled;
    } else if (const std::optional<Candidate> candidate = next_candidate()) {
      stop = take_turn(*candidate);
    } else {
      stop = StopReason::exhausted;
    }
  }
  result_.stop = *stop;
  result_.n_contractions = complex_.n_contractions();
  result_.n_vertices = complex_.n_vertices();
  result_.n_faces = complex_.n_faces();
  result_.max_cost = settings_.frame.cost_to_model(result_.max_cost, cost_times_area_);
  return result_;
}

bool ContractionLoop::target_reached() const {
  const DecimateTarget& target = settings_.target;
  return (target.faces && complex_.n_faces() <= *target.faces) ||
         (target.vertices && complex_.n_vertices() <= *target.vertices);
}

bool ContractionLoop::report_progress() const {
  if (!options_.progress) return true;
  const auto share = [](std::uint64_t initial, std::uint64_t now, std::optional<std::uint64_t> target) {
    if (!target || initial <= *target) return 0.0;
    return static_cast<double>(initial - now) / static_cast<double>(initial - *target);
  };
  const double faces = share(n_initial_faces_, complex_.n_faces(), settings_.target.faces);
  const double vertices = share(n_initial_vertices_, complex_.n_vertices(), settings_.target.vertices);
  return options_.progress({complex_.n_vertices(), complex_.n_faces(), std::min(1.0, std::max(faces, vertices))});
}

void ContractionLoop::fill_queue() {
  const std::size_t n_pairs = complex_.n_pair_slots();
  std::vector<BucketQueue::Bucket> buckets(n_pairs);
  std::vector<std::uint8_t> is_raised(n_pairs);
  const auto fill_range = [&](std::size_t begin, std::size_t end) {
    Parcel parcel;
    parcel.n = end - begin;
    for (std::size_t i = 0; i < parcel.n; ++i) {
      const auto id = static_cast<Index>(begin + i);
      const auto [a, b] = complex_.initial_ends(id);
      parcel.pairs[i] = {id, a, b};
    }
    evaluate(parcel);
    for (std::size_t i = 0; i < parcel.n; ++i) {
      const auto& [bound, cost, position, is_minimum] = parcel.evaluations[i];
      buckets[begin + i] = BucketQueue::bucket_of(cost);
      if (cost <= bound) continue;
      is_raised[begin + i] = 1;
      raised_costs_[begin + i] = static_cast<float>(cost);
    }
  };
  for_each_range(n_pairs, options_.threads, [&](std::size_t begin, std::size_t end) {
    for (; begin < end; begin += pairs_per_parcel) fill_range(begin, std::min(end, begin + pairs_per_parcel));
  });
  queue_.fill(buckets);
  for (Index pair = 0; pair < n_pairs; ++pair) {
    if (is_raised[pair] != 0) add_raised(pair_now(pair), raised_costs_[pair]);
  }
}

/// Puts the pairs in order and evaluates them, those that are by far the most several at once.
ContractionLoop::Parcel& ContractionLoop::evaluate(Parcel& parcel) const {
  const auto pairs = std::span(parcel.pairs).first(parcel.n);
  for (Pair& pair : pairs) pair = in_order(pair);
  if (options_.quadric.placement == Placement::optimal && settings_.locked.empty()) {
    const auto evaluations = std::span(parcel.evaluations).first(parcel.n);
    const auto is_edge = [this](const Pair& pair) { return !complex_.is_threshold_pair(pair.id); };
    const auto n_edges =
        static_cast<std::size_t>(std::partition_point(pairs.begin(), pairs.end(), is_edge) - pairs.begin());
    find_minima(complex_, pairs.first(n_edges), evaluations);
    find_minima(complex_, pairs.subspan(n_edges), evaluations.subspan(n_edges));
    for (std::size_t i = 0; i < parcel.n; ++i) {
      if (!evaluations[i].is_minimum) evaluations[i] = evaluate(pairs[i]);
    }
  } else {
    std::transform(pairs.begin(), pairs.end(), parcel.evaluations.begin(),
                   [this](const Pair& pair) { return evaluate(pair); });
  }
  return parcel;
}

std::optional<ContractionLoop::Candidate> ContractionLoop::next_candidate() {
  while (true) {
    const bool in_batch = n_taken_ < batch_.size();
    if (in_batch && (late_.empty() || is_before(batch_[n_taken_], late_.top()))) {
      prefetch_turns();
      return batch_[n_taken_++];
    }
    if (!late_.empty()) {
      const Candidate candidate = late_.top();
      late_.pop();
      return candidate;
    }
    if (!queue_.open_next(members_)) return std::nullopt;
    open_bucket();
  }
}

/// Makes the members of the bucket just opened candidates; those that have grown beyond it go to a later one.
void ContractionLoop::open_bucket() {
  batch_.clear();
  batch_.reserve(members_.size());
  placements_.clear();
  n_taken_ = 0;
  n_done_at_opening_ = complex_.n_contractions();
  sieve_.sift(members_);
  if (crew_.n_helpers() == 0 || members_.size() < fewest_shared) {
    evaluate_members();
  } else {
    evaluate_members_on_all_threads();
  }
  std::sort(batch_.begin(), batch_.end(), [](const Candidate& x, const Candidate& y) { return is_before(x, y); });
  if (complex_.has_threshold_pairs()) drop_duplicates();
}

/// Threshold pairs that have become the same, and what was queued twice.
void ContractionLoop::drop_duplicates() {
  const auto is_threshold_pair = [this](const Candidate& c) { return complex_.is_threshold_pair(c.pair.id); };
  const auto last = std::unique(batch_.begin(), batch_.end(), [&](const Candidate& x, const Candidate& y) {
    const bool is_same = x.tie == y.tie && is_threshold_pair(x) && is_threshold_pair(y);
    if (is_same && y.pair.id != x.pair.id) complex_.remove_pair(y.pair.id);
    return is_same;
  });
  batch_.erase(last, batch_.end());
}

/// The next parcel is looked up before the last one is evaluated, so that what it asks for has time to come.
void ContractionLoop::evaluate_members() {
  Parcel* last = nullptr;
  for (std::size_t begin = 0; begin < members_.size(); begin += pairs_per_parcel) {
    Parcel& next = parcels_[begin / pairs_per_parcel % 2];
    find_pairs(begin, std::min(members_.size(), begin + pairs_per_parcel), next);
    if (last != nullptr) sort_in(evaluate(*last));
    last = &next;
  }
  if (last != nullptr) sort_in(evaluate(*last));
}

/// The threads change nothing but each its own parcel, and `parents_` of the complex to the same.
void ContractionLoop::evaluate_members_on_all_threads() {
  const std::size_t at_once = parcels_.size() * pairs_per_parcel;
  for (std::size_t begin = 0; begin < members_.size(); begin += at_once) {
    const std::size_t n = std::min(members_.size() - begin, at_once);
    crew_.for_each_range(n, pairs_per_parcel, [this, begin](std::size_t first, std::size_t last) {
      Parcel& parcel = parcels_[first / pairs_per_parcel];
      find_pairs(begin + first, begin + last, parcel);
      evaluate(parcel);
    });
    for (std::size_t i = 0; i < n; i += pairs_per_parcel) sort_in(parcels_[i / pairs_per_parcel]);
  }
}

/// Looks up the ends of those of members begin … end that are still pairs. Brings near what comes next: the pairs, what
/// their ends have become, these.
void ContractionLoop::find_pairs(std::size_t begin, std::size_t end, Parcel& parcel) {
  std::size_t n = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (i + 16 < members_.size()) complex_.prefetch_pair(members_[i + 16]);
    if (i + 8 < members_.size()) complex_.prefetch_ends(members_[i + 8]);
    const auto [a, b] = complex_.ends(members_[i]);
    parcel.pairs[n] = {members_[i], a, b};
    n += static_cast<std::size_t>(complex_.is_pair_alive(members_[i]));
    complex_.prefetch_placed(a);
    complex_.prefetch_placed(b);
  }
  parcel.n = n;
}

void ContractionLoop::sort_in(const Parcel& parcel) {
  for (std::size_t i = 0; i < parcel.n; ++i) sort_in(parcel.pairs[i], parcel.evaluations[i]);
}

/// Into the batch, or, if it has grown, into a later bucket.
void ContractionLoop::sort_in(const Pair& pair, const PairEvaluation& evaluation) {
  note_raised(pair, evaluation);
  const BucketQueue::Bucket bucket = BucketQueue::bucket_of(evaluation.cost);
  if (!queue_.is_past(bucket)) return queue_.push(pair.id, bucket);
  batch_.push_back(candidate(pair, evaluation.cost));
  if (placements_.size() < most_placements) {
    batch_.back().placement = static_cast<Index>(placements_.size());
    placements_.push_back({evaluation.position, evaluation.is_minimum});
  }
  complex_.prefetch_star(pair.a);
  complex_.prefetch_star(pair.b);
}

Pair ContractionLoop::in_order(const Pair& pair) const {
  const bool is_a_first = complex_.origin(pair.a) < complex_.origin(pair.b);
  return {pair.id, select(is_a_first, pair.a, pair.b), select(is_a_first, pair.b, pair.a)};
}

Pair ContractionLoop::pair_now(Index id) const {
  const auto [a, b] = complex_.ends(id);
  return in_order({id, a, b});
}

ContractionLoop::Candidate ContractionLoop::candidate(const Pair& pair, double cost) const {
  return {cost, std::uint64_t{complex_.origin(pair.a)} << 32 | complex_.origin(pair.b), pair};
}

Pinned ContractionLoop::pinned(const Pair& pair) const {
  return is_locked(pair.a) ? Pinned::first : is_locked(pair.b) ? Pinned::second : Pinned::none;
}

/// One end of a pair, as the pair's cost sees it.
PlacedQuadric ContractionLoop::placed(const Pair& pair, Index v) const {
  return complex_.is_threshold_pair(pair.id) ? complex_.placed_with_points(v) : complex_.placed(v);
}

PairEvaluation ContractionLoop::evaluate(const Pair& pair) const {
  return evaluate_pair(placed(pair, pair.a), placed(pair, pair.b), options_.quadric.placement, pinned(pair));
}

void ContractionLoop::enqueue(const Candidate& candidate) {
  const BucketQueue::Bucket bucket = BucketQueue::bucket_of(candidate.cost);
  if (queue_.is_past(bucket)) {
    late_.push(candidate);
  } else {
    queue_.push(candidate.pair.id, bucket);
  }
}

/// Brings near what the turns to come will look at: first the lists, then the neighbours on them.
void ContractionLoop::prefetch_turns() {
  const auto candidate_ahead = [&](std::size_t n, auto prefetch) {
    if (n_taken_ + n >= batch_.size()) return;
    prefetch(batch_[n_taken_ + n].pair.a);
    prefetch(batch_[n_taken_ + n].pair.b);
  };
  candidate_ahead(8, [&](Index v) { complex_.prefetch_spokes(v); });
  candidate_ahead(4, [&](Index v) { complex_.prefetch_neighbours(v); });
}

/// Whether the candidate's cost and placement are what an evaluation would give now.
bool ContractionLoop::is_unchanged(const Candidate& candidate) const {
  return candidate.placement != invalid_index && complex_.last_change(candidate.pair.a) <= n_done_at_opening_ &&
         complex_.last_change(candidate.pair.b) <= n_done_at_opening_;
}

std::optional<StopReason> ContractionLoop::take_turn(const Candidate& then) {
  if (!complex_.is_pair_alive(then.pair.id)) return std::nullopt;
  Pair pair = then.pair;
  double cost = then.cost;
  Placed placement;
  if (is_unchanged(then)) {
    placement = placements_[then.placement];
  } else {
    pair = pair_now(pair.id);
    const PairEvaluation evaluation = evaluate(pair);
    const Candidate now = candidate(pair, evaluation.cost);
    if (is_before(then, now)) {  // it has grown since it was sorted in
      note_raised(pair, evaluation);
      enqueue(now);
      return std::nullopt;
    }
    cost = evaluation.cost;
    placement = {evaluation.position, evaluation.is_minimum};
  }
  if (!complex_.is_contractible(pair)) {
    complex_.remove_pair(pair.id);
    return std::nullopt;
  }
  if (settings_.target.max_cost && cost > *settings_.target.max_cost) return StopReason::cost;
  const Refusal refusal = find_refusal(pair, placement.position);
  if (refusal != Refusal::none) {
    refuse(pair, refusal);
  } else {
    contract(pair, cost, placement);
  }
  return std::nullopt;
}

ContractionLoop::Refusal ContractionLoop::find_refusal(const Pair& pair, const Vec3& position) {
  const auto [id, a, b] = pair;
  if (is_locked(a) && is_locked(b)) return Refusal::locked;
  complex_.gather(a, b, star_);
  const Refusal refusal = find_topological_refusal(pair);
  if (refusal != Refusal::none) return refusal;
  if (turns_a_face(complex_, flip_limit_, star_.first, complex_.position(a), position)) return Refusal::flip;
  if (turns_a_face(complex_, flip_limit_, star_.second, complex_.position(b), position)) return Refusal::flip;
  return Refusal::none;
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

void ContractionLoop::contract(const Pair& pair, double cost, const Placed& placement) {
  // The higher origin survives, so that no pair's place among ties moves forward; but a locked vertex stays.
  const auto [id, a, b] = pair;
  Index survivor = b;
  Index removed = a;
  if (is_locked(a)) {
    std::swap(survivor, removed);
  } else {
    std::swap(star_.first, star_.second);
  }
  complex_.contract(id, survivor, removed,
                    merged(placed(pair, a), placed(pair, b), placement.position, placement.is_minimum), star_);
  result_.threshold_pairs.contracted += static_cast<std::uint64_t>(complex_.is_threshold_pair(id));
  result_.max_cost = std::max(result_.max_cost, cost);
  if (options_.listener) {
    options_.listener({complex_.origin(survivor), complex_.origin(removed),
                       settings_.frame.to_model(placement.position),
                       settings_.frame.cost_to_model(cost, cost_times_area_)});
  }
  wake_raised(survivor, removed);
  wake_refused_around(survivor, removed);
  sieve_.merge(survivor, removed);
  if (!star_.is_joint || star_.joint.lost_edges.empty()) return;
  reveal_at(survivor);
  for (const PairStar::Opposite& neighbour : star_.joint.common) reveal_at(neighbour.vertex);
}

void ContractionLoop::wake_refused_around(Index survivor, Index removed) {
  const auto wake = [&](Index v) {
    if (refused_.any_at(v)) wake_refused_at(v);
  };
  const auto wake_neighbours = [&](Index v) {
    for (const Spoke& spoke : complex_.neighbours(v)) wake(spoke.vertex);
  };
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

void ContractionLoop::add_raised(const Pair& pair, double cost) {
  const auto [id, a, b] = pair;
  raised_costs_[id] = static_cast<float>(cost);
  if (is_raised_[id]) return;
  is_raised_[id] = true;
  raised_.add(a, id);
  raised_.add(b, id);
}

/// Queues anew those raised pairs at the merged vertex that have become cheaper.
void ContractionLoop::wake_raised(Index survivor, Index removed) {
  if (!raised_.any_at(survivor) && !raised_.any_at(removed)) return;
  woken_.clear();
  raised_.take(survivor, woken_);
  raised_.take(removed, woken_);
  for (const Index pair : woken_) {
    if (!complex_.is_pair_alive(pair)) continue;
    raised_.add(survivor, pair);
    const Pair now = pair_now(pair);
    const PairEvaluation evaluation = evaluate(now);
    if (static_cast<float>(evaluation.cost) > raised_costs_[pair]) continue;
    raised_costs_[pair] = static_cast<float>(evaluation.cost);
    enqueue(candidate(now, evaluation.cost));
  }
}

void ContractionLoop::refuse(const Pair& pair, Refusal refusal) {
  switch (refusal) {
    case Refusal::locked:
      ++result_.rejections.locked;
      return;  // for good
    case Refusal::link:
      ++result_.rejections.link;
      break;
    case Refusal::flip:
      ++result_.rejections.flip;
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

void ContractionLoop::wake_refused_at(Index v) {
  woken_.clear();
  refused_.take(v, woken_);
  for (const Index pair : woken_) {
    if (!is_refused_[pair]) continue;  // woken from its other vertex before
    is_refused_[pair] = false;
    if (complex_.is_pair_alive(pair)) queue_anew(pair_now(pair));
  }
}

/// Queues anew those pairs hidden at v that have lost their common faces.
void ContractionLoop::reveal_at(Index v) {
  woken_.clear();
  sieve_.reveal(v, woken_);
  for (const Index id : woken_) {
    if (!complex_.is_pair_alive(id)) continue;
    const Pair pair = pair_now(id);
    if (complex_.is_contractible(pair) && !sieve_.hides(pair)) queue_anew(pair);
  }
}

/// A pair that was in no queue.
void ContractionLoop::queue_anew(const Pair& pair) {
  const PairEvaluation evaluation = evaluate(pair);
  note_raised(pair, evaluation);
  enqueue(candidate(pair, evaluation.cost));
}

}  // namespace whittle
