#include "queue/lazy_queue.hh"

#include <algorithm>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/detail/select.hh"

namespace whittle {

namespace {

/// Buckets with at least so many members are shared among threads: some tens of microseconds of work.
constexpr std::size_t fewest_shared = 256;

/// Batches that are shared among threads at a time. On flat ground all pairs may be in one bucket.
constexpr std::size_t n_shared_batches = 64;

/// Candidates whose placements are remembered.
constexpr std::size_t most_placements = 8192;

}  // namespace

LazyQueue::LazyQueue(TriangleComplex& complex, const PairRanks& ranks, ThresholdPairFilter& filter,
                     const RefusedPairs& refused, const UncertainVertices* uncertain, unsigned threads)
    : complex_(complex),
      ranks_(ranks),
      filter_(filter),
      uncertain_(uncertain),
      thread_pool_(threads),
      batches_(thread_pool_.n_helpers() == 0 ? 2 : n_shared_batches),
      raised_(complex.n_vertex_slots()),
      is_raised_(complex.n_pair_slots()),
      raised_costs_(std::make_unique_for_overwrite<float[]>(complex.n_pair_slots())) {
  fill_queue(refused, threads);
}

bool LazyQueue::is_queued_at_first(const TriangleComplex::Ends& ends) const {
  const bool is_first_frozen = complex_.is_frozen(ends.first);
  const bool is_second_frozen = complex_.is_frozen(ends.second);
  return uncertain_ ? !(is_first_frozen && is_second_frozen) : !(is_first_frozen || is_second_frozen);
}

void LazyQueue::fill_queue(const RefusedPairs& refused, unsigned threads) {
  const std::size_t n_pairs = complex_.n_pair_slots();
  std::vector<BucketQueue::Bucket> buckets(n_pairs, BucketQueue::no_bucket);
  std::vector<std::uint8_t> is_raised(n_pairs);
  const auto fill_range = [&](std::size_t begin, std::size_t end) {
    Batch batch;
    for (auto id = static_cast<Index>(begin); id < end; ++id) {
      const TriangleComplex::Ends ends = complex_.initial_ends(id);
      batch.pairs[batch.n] = {id, ends.first, ends.second};
      batch.n += static_cast<std::size_t>(is_queued_at_first(ends) && refused.refuser(id) == RefusedPairs::none);
    }
    evaluate(batch, 0);
    for (std::size_t i = 0; i < batch.n; ++i) {
      const Index id = batch.pairs[i].id;
      const auto& [bound, cost, position, is_minimum] = batch.evaluations[i];
      buckets[id] = BucketQueue::bucket_of(cost);
      if (cost <= bound) continue;
      is_raised[id] = 1;
      raised_costs_[id] = static_cast<float>(cost);
    }
  };
  for_each_range(n_pairs, threads, [&](std::size_t begin, std::size_t end) {
    for (; begin < end; begin += pairs_per_batch) fill_range(begin, std::min(end, begin + pairs_per_batch));
  });
  queue_.fill(buckets);
  for (Index pair = 0; pair < n_pairs; ++pair) {
    if (is_raised[pair] != 0) add_raised(pair_now(complex_, pair), raised_costs_[pair]);
  }
}

/// Ranks the pairs, each with the lower origin first. Pairs that cost `enough` have to wait in any case.
LazyQueue::Batch& LazyQueue::evaluate(Batch& batch, double enough) const {
  const auto pairs = std::span(batch.pairs).first(batch.n);
  for (Pair& pair : pairs) pair = in_order(complex_, pair);
  rank(pairs, std::span(batch.evaluations).first(batch.n), enough);
  return batch;
}

void LazyQueue::rank(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations, double enough) const {
  ranks_.rank(pairs, evaluations, enough);
  if (uncertain_ == nullptr) return;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (uncertain_->contains_any(pairs[i])) evaluations[i].cost = evaluations[i].bound;
  }
}

PairEvaluation LazyQueue::rank(const Pair& pair, double enough) const {
  PairEvaluation evaluation;
  rank({&pair, 1}, {&evaluation, 1}, enough);
  return evaluation;
}

std::optional<RankedPair> LazyQueue::next() {
  while (const std::optional<Candidate> candidate = next_candidate()) {
    if (std::optional<RankedPair> turn = turn_of(*candidate)) return turn;
  }
  return std::nullopt;
}

/// The candidate as it is now. nullopt if it is no pair any more, or costs more and is queued again.
std::optional<RankedPair> LazyQueue::turn_of(const Candidate& then) {
  if (!complex_.is_pair_alive(then.pair.id)) return std::nullopt;
  if (is_unchanged(then)) {
    const auto& [bound, position, is_minimum] = placements_[then.placement];
    return RankedPair{then.pair, {bound, then.cost, position, is_minimum}};
  }
  const Pair pair = pair_now(complex_, then.pair.id);
  const PairEvaluation evaluation = rank(pair);
  const Candidate now = candidate(complex_, pair, evaluation.cost);
  if (!is_before(then, now)) return RankedPair{pair, evaluation};
  note_raised(pair, evaluation);
  enqueue(now);
  return std::nullopt;
}

std::optional<Candidate> LazyQueue::next_candidate() {
  do {
    prefetch_turns();
    if (const std::optional<Candidate> candidate = open_.take()) return candidate;
  } while (open_bucket());
  return std::nullopt;
}

/// Makes candidates of the members of the bucket just opened. Members that cost more now go to a later bucket. False if
/// there is no bucket left.
bool LazyQueue::open_bucket() {
  if (!queue_.open_next(members_)) return false;
  open_.open(members_.size());
  placements_.clear();
  n_done_at_opening_ = complex_.n_contractions();
  filter_.apply(members_);
  if (thread_pool_.n_helpers() == 0 || members_.size() < fewest_shared) {
    evaluate_members();
  } else {
    evaluate_members_on_all_threads();
  }
  open_.sort();
  if (complex_.has_threshold_pairs()) drop_duplicates();
  return true;
}

/// Drops threshold pairs that have become equal, and those queued twice.
void LazyQueue::drop_duplicates() {
  const auto is_threshold_pair = [this](const Candidate& c) { return complex_.is_threshold_pair(c.pair.id); };
  open_.drop_repeated([&](const Candidate& x, const Candidate& y) {
    const bool is_same = x.tie == y.tie && is_threshold_pair(x) && is_threshold_pair(y);
    if (is_same && y.pair.id != x.pair.id) complex_.remove_pair(y.pair.id);
    return is_same;
  });
}

/// The next batch is looked up before the last one is ranked, so that its prefetches have time.
void LazyQueue::evaluate_members() {
  Batch* last = nullptr;
  for (std::size_t begin = 0; begin < members_.size(); begin += pairs_per_batch) {
    Batch& next = batches_[begin / pairs_per_batch % 2];
    find_pairs(begin, std::min(members_.size(), begin + pairs_per_batch), next);
    if (last != nullptr) sort_in(evaluate(*last, queue_.end_of_past()));
    last = &next;
  }
  if (last != nullptr) sort_in(evaluate(*last, queue_.end_of_past()));
}

/// Each thread writes to its own batch. All may shorten paths in the complex' `parents_`, to the same values.
void LazyQueue::evaluate_members_on_all_threads() {
  const std::size_t at_once = batches_.size() * pairs_per_batch;
  for (std::size_t begin = 0; begin < members_.size(); begin += at_once) {
    const std::size_t n = std::min(members_.size() - begin, at_once);
    thread_pool_.for_each_range(n, pairs_per_batch, [this, begin](std::size_t first, std::size_t last) {
      Batch& batch = batches_[first / pairs_per_batch];
      find_pairs(begin + first, begin + last, batch);
      evaluate(batch, queue_.end_of_past());
    });
    for (std::size_t i = 0; i < n; i += pairs_per_batch) sort_in(batches_[i / pairs_per_batch]);
  }
}

/// Looks up the ends of members begin … end that are still pairs. Prefetches what comes next: pairs, their ends, and
/// the vertices that these have become.
void LazyQueue::find_pairs(std::size_t begin, std::size_t end, Batch& batch) {
  const KeptOfVertices kept = ranks_.kept();
  const auto prefetch_end = [&](Index v) {
    complex_.prefetch_vertex(v);
    kept.prefetch(v);
  };
  std::size_t n = 0;
  for (std::size_t i = begin; i < end; ++i) {
    if (i + 16 < members_.size()) complex_.prefetch_pair(members_[i + 16]);
    if (i + 8 < members_.size()) complex_.prefetch_ends(members_[i + 8]);
    const auto [a, b] = complex_.ends(members_[i]);
    batch.pairs[n] = {members_[i], a, b};
    n += static_cast<std::size_t>(complex_.is_pair_alive(members_[i]));
    prefetch_end(a);
    prefetch_end(b);
    is_raised_.prefetch(members_[i]);
  }
  batch.n = n;
}

void LazyQueue::sort_in(const Batch& batch) {
  for (std::size_t i = 0; i < batch.n; ++i) sort_in(batch.pairs[i], batch.evaluations[i]);
}

/// Into the open bucket, or into a later bucket if it costs more now.
void LazyQueue::sort_in(const Pair& pair, const PairEvaluation& evaluation) {
  note_raised(pair, evaluation);
  const BucketQueue::Bucket bucket = BucketQueue::bucket_of(evaluation.cost);
  if (!queue_.is_past(bucket)) return queue_.push(pair.id, bucket);
  Candidate member = candidate(complex_, pair, evaluation.cost);
  if (placements_.size() < most_placements) {
    member.placement = static_cast<Index>(placements_.size());
    placements_.push_back({evaluation.bound, evaluation.position, evaluation.is_minimum});
  }
  open_.add(member);
  complex_.prefetch_star(pair.a);
  complex_.prefetch_star(pair.b);
}

void LazyQueue::enqueue(const Candidate& candidate) {
  const BucketQueue::Bucket bucket = BucketQueue::bucket_of(candidate.cost);
  if (queue_.is_past(bucket)) {
    open_.add_late(candidate);
  } else {
    queue_.push(candidate.pair.id, bucket);
  }
}

/// Prefetches what the next turns look at: first the lists, then the neighbours on them.
void LazyQueue::prefetch_turns() {
  const auto candidate_ahead = [&](std::size_t n, auto prefetch) {
    const Candidate* candidate = open_.ahead(n);
    if (candidate == nullptr) return;
    prefetch(candidate->pair.a);
    prefetch(candidate->pair.b);
  };
  candidate_ahead(8, [&](Index v) { complex_.prefetch_list(v); });
  candidate_ahead(
      4, [&](Index v) { complex_.for_each_likely_neighbour(v, [this](Index w) { complex_.prefetch_vertex(w); }); });
  candidate_ahead(3, [&](Index v) { raised_.prefetch(v); });
  const KeptOfVertices kept = ranks_.kept();
  if (kept.changes_around_merged) {  // the ends are neighbours of each other
    candidate_ahead(3, [&](Index v) { complex_.for_each_likely_neighbour(v, [&](Index w) { kept.prefetch(w); }); });
  } else {
    candidate_ahead(3, [&](Index v) { kept.prefetch(v); });
  }
}

/// Whether ranking the candidate now would give the cost and placement that it has.
bool LazyQueue::is_unchanged(const Candidate& candidate) const {
  return candidate.placement != invalid_index && ranks_.reads() == Reach::none &&
         complex_.last_change(candidate.pair.a) <= n_done_at_opening_ &&
         complex_.last_change(candidate.pair.b) <= n_done_at_opening_;
}

void LazyQueue::add_raised(const Pair& pair, double cost) {
  const auto [id, a, b] = pair;
  raised_costs_[id] = static_cast<float>(cost);
  if (is_raised_.test(id)) return;
  is_raised_.set(id);
  raised_.add(a, id);
  raised_.add(b, id);
}

void LazyQueue::add(const Pair& pair) {
  const PairEvaluation evaluation = rank(pair);
  note_raised(pair, evaluation);
  enqueue(candidate(complex_, pair, evaluation.cost));
}

bool LazyQueue::postpone(const Pair& pair, double cost) {
  const BucketQueue::Bucket bucket = BucketQueue::bucket_of(cost);
  if (queue_.is_past(bucket)) return false;
  queue_.push(pair.id, bucket);
  return true;
}

void LazyQueue::list_raised(Index v, std::vector<Index>& ids) const {
  raised_.for_each_at(v, [&](Index id) { ids.push_back(id); });
}

void LazyQueue::note(const Change& change) {
  queue_cheaper(change);
  const bool moves_forward = complex_.origin(change.survivor) < complex_.origin(change.removed);
  if (moves_forward && ranks_.affects() == Reach::none) queue_all_at(change.survivor);
}

/// Queues again the raised pairs at the merged vertex that have become cheaper.
void LazyQueue::queue_cheaper(const Change& change) {
  const Index survivor = change.survivor;
  const Index removed = change.removed;
  if (!raised_.any_at(survivor) && !raised_.any_at(removed)) return;
  woken_.clear();
  raised_.take(survivor, woken_);
  raised_.take(removed, woken_);
  for (const Index pair : woken_) {
    if (!complex_.is_pair_alive(pair)) continue;
    raised_.add(survivor, pair);
    const Pair now = pair_now(complex_, pair);
    const PairEvaluation evaluation = rank(now, 2 * raised_costs_[pair]);
    if (static_cast<float>(evaluation.cost) > raised_costs_[pair]) continue;
    raised_costs_[pair] = static_cast<float>(evaluation.cost);
    enqueue(candidate(complex_, now, evaluation.cost));
  }
}

/// Where the lower origin survives, the pairs of the other one come earlier among equal costs than they were queued.
void LazyQueue::queue_all_at(Index survivor) {
  for (const Neighbour& neighbour : complex_.neighbours(survivor)) {
    if (!complex_.is_pair_alive(neighbour.edge)) continue;
    const Pair now = pair_now(complex_, neighbour.edge);
    enqueue(candidate(complex_, now, rank(now).cost));
  }
}

}  // namespace whittle
