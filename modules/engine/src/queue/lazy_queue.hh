#pragma once

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "complex/uncertain_vertices.hh"
#include "pairs/threshold_pair_filter.hh"
#include "queue/bucket_queue.hh"
#include "queue/open_bucket.hh"
#include "queue/pair_queue.hh"
#include "queue/refused_pairs.hh"
#include "queue/waiting_pairs.hh"
#include "whittle/core/detail/thread_pool.hh"

namespace whittle {

/// The queue for costs with a lower bound (`PairEvaluation::bound`): a pair waits under the bound, so a contraction
/// touches no other entry. All pairs of a bucket are ranked together when it is opened. A pair is ranked once more when
/// its turn comes, if one of its vertices has changed. Only raised pairs can get cheaper:
/// - raised: the cost is above the bound (constraint, or placed elsewhere than at the minimum). It is queued under its
///   cost, and waits at its vertices to be ranked again when one of them merges.
///
/// With a cost that has no such bound the order is approximate: a pair that a contraction nearby has made cheaper is
/// noticed only when its old turn comes.
class LazyQueue final : public PairQueue {
 public:
  /// \param refused pairs that are not queued at first
  /// \param uncertain if not null: of a pair with such an end no more is known than that it costs at least its bound.
  /// Then pairs with one frozen end are queued, too
  LazyQueue(TriangleComplex& complex, const PairRanks& ranks, ThresholdPairFilter& filter, const RefusedPairs& refused,
            const UncertainVertices* uncertain, unsigned threads);

  std::optional<RankedPair> next() override;
  void add(const Pair& pair) override;
  bool postpone(const Pair& pair, double cost) override;
  void list_raised(Index v, std::vector<Index>& ids) const override;
  void note(const Change& change) override;

 private:
  static constexpr std::size_t pairs_per_batch = 64;

  /// Where the merged vertex of a pair would go.
  struct Placed {
    double bound;
    Vec3 position;
    bool is_minimum;
  };
  /// Pairs that are ranked together, edges first: some microseconds of work, within the first-level cache.
  struct Batch {
    std::size_t n = 0;
    std::array<Pair, pairs_per_batch> pairs;
    std::array<PairEvaluation, pairs_per_batch> evaluations;
  };

  bool is_queued_at_first(const TriangleComplex::Ends& ends) const;
  void fill_queue(const RefusedPairs& refused, unsigned threads);
  void rank(std::span<const Pair> pairs, std::span<PairEvaluation> evaluations, double enough) const;
  PairEvaluation rank(const Pair& pair, double enough = std::numeric_limits<double>::infinity()) const;
  std::optional<Candidate> next_candidate();
  std::optional<RankedPair> turn_of(const Candidate& then);
  bool open_bucket();
  void drop_duplicates();
  void evaluate_members();
  void evaluate_members_on_all_threads();
  void find_pairs(std::size_t begin, std::size_t end, Batch& batch);
  Batch& evaluate(Batch& batch, double enough) const;
  void sort_in(const Batch& batch);
  void sort_in(const Pair& pair, const PairEvaluation& evaluation);
  void prefetch_turns();
  void enqueue(const Candidate& candidate);
  void queue_cheaper(const Change& change);
  void queue_all_at(Index survivor);
  bool is_unchanged(const Candidate& candidate) const;

  void note_raised(const Pair& pair, const PairEvaluation& evaluation) {
    if (evaluation.cost > evaluation.bound || is_raised_.test(pair.id)) add_raised(pair, evaluation.cost);
  }
  void add_raised(const Pair& pair, double cost);

  TriangleComplex& complex_;
  const PairRanks& ranks_;
  ThresholdPairFilter& filter_;
  const UncertainVertices* uncertain_;
  ThreadPool thread_pool_;

  BucketQueue queue_;
  std::vector<Index> members_;  ///< of the bucket being opened
  std::vector<Batch> batches_;  ///< scratch: a thread works on one at a time
  OpenBucket open_;
  std::vector<Placed> placements_;  ///< where the merged vertices would go
  Index n_done_at_opening_ = 0;     ///< number of contractions when the bucket was opened

  WaitingPairs raised_;
  detail::BitSet is_raised_;               ///< per pair
  std::unique_ptr<float[]> raised_costs_;  ///< per pair, what a raised one is queued under; undefined for others
  std::vector<Index> woken_;               ///< scratch
};

}  // namespace whittle
