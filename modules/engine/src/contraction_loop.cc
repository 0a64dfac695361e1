#include "contraction_loop.hh"

#include <algorithm>
#include <array>

#include "whittle/engine/parallel.hh"

namespace whittle {

namespace {

/// Candidates between two calls of the progress callback: about a millisecond.
constexpr std::uint64_t progress_interval = 2048;

}  // namespace

ContractionLoop::ContractionLoop(TriangleComplex& complex, std::vector<Quadric> quadrics,
                                 const DecimateOptions& options, LoopSettings settings)
    : complex_(complex),
      quadrics_(std::move(quadrics)),
      options_(options),
      settings_(std::move(settings)),
      flip_limit_(options.max_normal_flip_deg),
      cost_times_area_(options.quadric.weights != Weights::uniform),
      n_initial_vertices_(complex.n_vertices()),
      n_initial_faces_(complex.n_faces()),
      raised_(complex.n_vertex_slots()),
      is_raised_(complex.n_edge_slots()),
      refused_(complex.n_vertex_slots()),
      is_refused_(complex.n_edge_slots()) {}

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
  const std::size_t n_pairs = complex_.n_edge_slots();
  queue_.reserve(n_pairs);
  struct Place {
    BucketQueue::Bucket bucket;
    bool is_raised;
  };
  std::vector<Place> places(n_pairs);
  for_each_range(n_pairs, options_.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t pair = begin; pair < end; ++pair) {
      const auto [a, b] = complex_.initial_ends(static_cast<Index>(pair));
      const PairEvaluation evaluation = evaluate(a, b);
      places[pair] = {BucketQueue::bucket_of(evaluation.cost), evaluation.cost > evaluation.bound};
    }
  });
  for (Index pair = 0; pair < n_pairs; ++pair) {
    queue_.push(pair, places[pair].bucket);
    if (!places[pair].is_raised) continue;
    const auto [a, b] = complex_.initial_ends(pair);
    add_raised(pair, a, b, evaluate(a, b).cost);
  }
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
  resolve_members();
  batch_.clear();
  n_taken_ = 0;
  for (std::size_t i = 0; i < resolved_.size(); ++i) {
    if (i + 16 < resolved_.size()) {
      prefetch_vertex(resolved_[i + 16].a);
      prefetch_vertex(resolved_[i + 16].b);
    }
    const auto [pair, a, b] = resolved_[i];
    const PairEvaluation evaluation = evaluate(a, b);
    note_raised(pair, a, b, evaluation);
    const BucketQueue::Bucket bucket = BucketQueue::bucket_of(evaluation.cost);
    if (queue_.is_past(bucket)) {
      batch_.push_back({evaluation.cost, pair, a, b});
    } else {
      queue_.push(pair, bucket);
    }
  }
  std::sort(batch_.begin(), batch_.end(), [this](const Candidate& x, const Candidate& y) { return is_before(x, y); });
}

/// Finds the vertices of the members that still are pairs.
void ContractionLoop::resolve_members() {
  resolved_.clear();
  std::erase_if(members_, [&](Index pair) { return !complex_.is_edge_alive(pair); });
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (i + 32 < members_.size()) complex_.prefetch_edge(members_[i + 32]);
    if (i + 16 < members_.size()) complex_.prefetch_ends(members_[i + 16]);
    const auto [a, b] = complex_.ends(members_[i]);
    resolved_.push_back({members_[i], a, b});
  }
}

void ContractionLoop::prefetch_vertex(Index v) const {
  complex_.prefetch_vertex(v);
  const char* quadric = reinterpret_cast<const char*>(&quadrics_[v]);
  prefetch(quadric);
  prefetch(quadric + 64);
}

PairEvaluation ContractionLoop::evaluate(Index a, Index b) const {
  const Pinned pinned = is_locked(a) ? Pinned::first : is_locked(b) ? Pinned::second : Pinned::none;
  return evaluate_pair(quadrics_[a], complex_.position(a), quadrics_[b], complex_.position(b),
                       options_.quadric.placement, pinned);
}

/// Ties go by the lower, then the higher original number of the two vertices.
bool ContractionLoop::is_before_at_equal_cost(const Candidate& x, const Candidate& y) const {
  const auto key = [this](const Candidate& c) {
    const Index origin_a = complex_.origin(c.a);
    const Index origin_b = complex_.origin(c.b);
    return std::array{std::min(origin_a, origin_b), std::max(origin_a, origin_b), c.pair};
  };
  return key(x) < key(y);
}

void ContractionLoop::enqueue(const Candidate& candidate) {
  const BucketQueue::Bucket bucket = BucketQueue::bucket_of(candidate.cost);
  if (queue_.is_past(bucket)) {
    late_.push(candidate);
  } else {
    queue_.push(candidate.pair, bucket);
  }
}

/// Brings near what the turns to come will look at: first the lists, then the faces on them, then their corners.
void ContractionLoop::prefetch_turns() const {
  const auto candidate_ahead = [&](std::size_t n, auto prefetch) {
    if (n_taken_ + n >= batch_.size()) return;
    prefetch(batch_[n_taken_ + n].a);
    prefetch(batch_[n_taken_ + n].b);
  };
  candidate_ahead(12, [&](Index v) { complex_.prefetch_face_list(v); });
  candidate_ahead(8, [&](Index v) { complex_.prefetch_faces(v); });
  candidate_ahead(4, [&](Index v) { complex_.prefetch_neighbours(v); });
}

std::optional<StopReason> ContractionLoop::take_turn(const Candidate& candidate) {
  if (!complex_.is_edge_alive(candidate.pair)) return std::nullopt;
  auto [a, b] = complex_.ends(candidate.pair);
  if (complex_.origin(b) < complex_.origin(a)) std::swap(a, b);
  const PairEvaluation evaluation = evaluate(a, b);
  const Candidate now{evaluation.cost, candidate.pair, a, b};
  if (is_before(candidate, now)) {  // it has grown since it was sorted in
    note_raised(candidate.pair, a, b, evaluation);
    enqueue(now);
    return std::nullopt;
  }
  if (settings_.target.max_cost && evaluation.cost > *settings_.target.max_cost) return StopReason::cost;
  const Refusal refusal = find_refusal(a, b, evaluation.position);
  if (refusal != Refusal::none) {
    refuse(candidate.pair, a, b, refusal);
  } else {
    contract(a, b, evaluation);
  }
  return std::nullopt;
}

ContractionLoop::Refusal ContractionLoop::find_refusal(Index a, Index b, const Vec3& position) {
  if (is_locked(a) && is_locked(b)) return Refusal::locked;
  complex_.gather(a, b, star_);
  if (!complex_.link_condition(a, b, star_)) return Refusal::link;
  if (turns_a_face(star_.first, complex_.position(a), position)) return Refusal::flip;
  if (turns_a_face(star_.second, complex_.position(b), position)) return Refusal::flip;
  return Refusal::none;
}

/// Whether moving the common corner of `wings` turns one of them too far.
bool ContractionLoop::turns_a_face(const std::vector<PairStar::Wing>& wings, const Vec3& from, const Vec3& to) const {
  return std::any_of(wings.begin(), wings.end(), [&](const PairStar::Wing& wing) {
    return flip_limit_.is_exceeded(from, to, complex_.position(wing.x), complex_.position(wing.y));
  });
}

void ContractionLoop::contract(Index a, Index b, const PairEvaluation& evaluation) {
  // The higher origin survives, so that no pair's place among ties moves forward; but a locked vertex stays.
  Index survivor = b;
  Index removed = a;
  if (is_locked(a)) {
    std::swap(survivor, removed);
  } else {
    std::swap(star_.first, star_.second);
  }
  quadrics_[survivor] =
      merged_quadric(quadrics_[a], complex_.position(a), quadrics_[b], complex_.position(b), evaluation.position);
  complex_.contract(survivor, removed, evaluation.position, star_);
  ++result_.n_contractions;
  result_.max_cost = std::max(result_.max_cost, evaluation.cost);
  if (options_.listener) {
    options_.listener({complex_.origin(survivor), complex_.origin(removed),
                       settings_.frame.to_model(evaluation.position),
                       settings_.frame.cost_to_model(evaluation.cost, cost_times_area_)});
  }

  wake_raised(survivor, removed);
  wake_refused_around(survivor, removed);
}

void ContractionLoop::wake_refused_around(Index survivor, Index removed) {
  const auto wake = [&](Index v) {
    if (refused_.any_at(v)) wake_refused_at(v);
  };
  wake(survivor);
  wake(removed);
  for (const auto* wings : {&star_.first, &star_.second}) {
    for (const PairStar::Wing& wing : *wings) {
      wake(wing.x);
      wake(wing.y);
    }
  }
  for (const PairStar::Shared& shared : star_.shared) wake(shared.opposite);
}

void ContractionLoop::add_raised(Index pair, Index a, Index b, double cost) {
  raised_costs_.resize(complex_.n_edge_slots());
  raised_costs_[pair] = static_cast<float>(cost);
  if (is_raised_[pair]) return;
  is_raised_[pair] = true;
  raised_.add(a, pair);
  raised_.add(b, pair);
}

/// Queues anew those raised pairs at the merged vertex that have become cheaper.
void ContractionLoop::wake_raised(Index survivor, Index removed) {
  if (!raised_.any_at(survivor) && !raised_.any_at(removed)) return;
  woken_.clear();
  raised_.take(survivor, woken_);
  raised_.take(removed, woken_);
  for (const Index pair : woken_) {
    if (!complex_.is_edge_alive(pair)) continue;
    const auto [a, b] = complex_.ends(pair);
    raised_.add(survivor, pair);
    const PairEvaluation evaluation = evaluate(a, b);
    if (static_cast<float>(evaluation.cost) > raised_costs_[pair]) continue;
    raised_costs_[pair] = static_cast<float>(evaluation.cost);
    enqueue({evaluation.cost, pair, a, b});
  }
}

void ContractionLoop::refuse(Index pair, Index a, Index b, Refusal refusal) {
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
    case Refusal::none:
      return;
  }
  if (is_refused_[pair]) return;
  is_refused_[pair] = true;
  refused_.add(a, pair);
  refused_.add(b, pair);
}

void ContractionLoop::wake_refused_at(Index v) {
  woken_.clear();
  refused_.take(v, woken_);
  for (const Index pair : woken_) {
    if (!is_refused_[pair]) continue;  // woken from its other vertex before
    is_refused_[pair] = false;
    if (!complex_.is_edge_alive(pair)) continue;
    const auto [a, b] = complex_.ends(pair);
    const PairEvaluation evaluation = evaluate(a, b);
    note_raised(pair, a, b, evaluation);
    enqueue({evaluation.cost, pair, a, b});
  }
}

}  // namespace whittle
