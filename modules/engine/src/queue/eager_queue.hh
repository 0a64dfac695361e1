#pragma once

#include <vector>

#include "queue/bucket_queue.hh"
#include "queue/open_bucket.hh"
#include "queue/pair_queue.hh"
#include "whittle/core/detail/large_array.hh"

namespace whittle {

/// The queue for costs that a contraction nearby may lower. After each contraction all pairs that it affects
/// are ranked again, so every pair's cost is known at any time.
///
/// A queued pair has an entry in the bucket of its cost. If that bucket has been opened, the entry is among the
/// candidates instead. Entries under older costs are skipped. Edges only.
class EagerQueue final : public PairQueue {
 public:
  EagerQueue(TriangleComplex& complex, const PairRanks& ranks, unsigned threads);

  std::optional<RankedPair> next() override;
  void add(const Pair& pair) override;
  bool postpone(const Pair& pair, double cost) override;
  void note(const Change& change) override;

 private:
  /// The cost of pairs that are not queued.
  static constexpr double out = -1;

  void fill_queue(unsigned threads);
  std::optional<Candidate> next_candidate();
  bool open_bucket();
  bool is_current(const Candidate& entry) const;
  void collect_pairs_at(Index v);
  void set_cost(const Pair& pair, double cost);

  TriangleComplex& complex_;
  const PairRanks& ranks_;
  LargeArray<double> costs_;  ///< per pair
  double cost_now_ = 0;       ///< of the pair taken out last
  BucketQueue queue_;
  std::vector<Index> members_;  ///< of the bucket being opened
  OpenBucket open_;
  std::vector<Index> last_looked_at_;  ///< per pair, the number of contractions when it was last collected
  std::vector<Pair> pairs_;            ///< scratch: the pairs that a contraction affects
  std::vector<PairEvaluation> evaluations_;
};

}  // namespace whittle
