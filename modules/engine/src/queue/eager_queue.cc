#include "queue/eager_queue.hh"

#include "whittle/core/detail/parallel.hh"

namespace whittle {

EagerQueue::EagerQueue(TriangleComplex& complex, const PairRanks& ranks, unsigned threads)
    : complex_(complex), ranks_(ranks), last_looked_at_(complex.n_pair_slots()) {
  costs_.resize(complex.n_pair_slots());
  fill_queue(threads);
}

void EagerQueue::fill_queue(unsigned threads) {
  std::vector<BucketQueue::Bucket> buckets(costs_.size());
  for_each_range(costs_.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::vector<Pair> pairs;
    for (auto id = static_cast<Index>(begin); id < end; ++id) {
      const auto [a, b] = complex_.initial_ends(id);
      pairs.push_back(in_order(complex_, {id, a, b}));
    }
    std::vector<PairEvaluation> evaluations(pairs.size());
    ranks_.rank(pairs, evaluations);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      costs_[begin + i] = evaluations[i].cost;
      buckets[begin + i] = BucketQueue::bucket_of(evaluations[i].cost);
    }
  });
  queue_.fill(buckets);
}

std::optional<RankedPair> EagerQueue::next() {
  while (const std::optional<Candidate> candidate = next_candidate()) {
    costs_[candidate->pair.id] = out;
    cost_now_ = candidate->cost;
    const Pair pair = pair_now(complex_, candidate->pair.id);
    const PairEvaluation rank = ranks_.rank(pair);
    if (!(rank.cost > candidate->cost)) return RankedPair{pair, rank};
    set_cost(pair, rank.cost);  // a host's cost may have risen without being told
  }
  return std::nullopt;
}

std::optional<Candidate> EagerQueue::next_candidate() {
  do {
    while (const std::optional<Candidate> candidate = open_.take()) {
      if (is_current(*candidate)) return candidate;
    }
  } while (open_bucket());
  return std::nullopt;
}

bool EagerQueue::is_current(const Candidate& entry) const {
  const Index id = entry.pair.id;
  if (!complex_.is_pair_alive(id) || costs_[id] != entry.cost) return false;
  return candidate(complex_, pair_now(complex_, id), entry.cost).tie == entry.tie;
}

/// False if there is none left.
bool EagerQueue::open_bucket() {
  if (!queue_.open_next(members_)) return false;
  open_.open(members_.size());
  for (const Index id : members_) {
    if (!complex_.is_pair_alive(id) || costs_[id] == out) continue;
    if (!queue_.is_past(BucketQueue::bucket_of(costs_[id]))) continue;
    open_.add(candidate(complex_, pair_now(complex_, id), costs_[id]));
  }
  open_.sort();
  return true;
}

void EagerQueue::add(const Pair& pair) { set_cost(pair, ranks_.rank(pair).cost); }

bool EagerQueue::postpone(const Pair& pair, double cost) {
  if (!(cost > cost_now_)) return false;
  set_cost(pair, cost);
  return true;
}

/// Puts the pair where its cost says, unless it is there.
void EagerQueue::set_cost(const Pair& pair, double cost) {
  const double before = costs_[pair.id];
  costs_[pair.id] = cost;
  const BucketQueue::Bucket bucket = BucketQueue::bucket_of(cost);
  if (queue_.is_past(bucket)) {  // there its vertices' numbers count, too
    open_.add_late(candidate(complex_, pair, cost));
  } else if (before == out || bucket != BucketQueue::bucket_of(before)) {
    queue_.push(pair.id, bucket);
  }
}

void EagerQueue::note(const Change& change) {
  pairs_.clear();
  for (const Index v : change.touched) collect_pairs_at(v);
  evaluations_.resize(pairs_.size());
  ranks_.rank(pairs_, evaluations_);
  for (std::size_t i = 0; i < pairs_.size(); ++i) set_cost(pairs_[i], evaluations_[i].cost);
}

/// Those that are in. \pre v's list is compact
void EagerQueue::collect_pairs_at(Index v) {
  for (const Neighbour& neighbour : complex_.neighbours(v)) {
    const Index id = neighbour.edge;
    if (costs_[id] == out || last_looked_at_[id] == complex_.n_contractions()) continue;
    last_looked_at_[id] = complex_.n_contractions();
    pairs_.push_back(in_order(complex_, {id, v, neighbour.vertex}));
  }
}

}  // namespace whittle
