#pragma once

#include <memory>
#include <span>
#include <vector>

#include "guard/error_guard.hh"
#include "loop/stage_context.hh"
#include "queue/pair_queue.hh"
#include "whittle/core/detail/thread_pool.hh"

namespace whittle {

/// Where the merged vertex of a pair may go.
struct MergedPlace {
  Vec3 position;
  Index survivor;
};

/// Pairs that error guards look at on all threads, as no two of them have a neighbour in common. Which pairs these are,
/// and what is found, is the same on any number of threads.
class PairsAtOnce {
 public:
  /// A pair with its turn.
  struct Entry {
    RankedPair ranked{};
    std::vector<MergedPlace> places{};
    std::size_t next = 0;      ///< place to look at; the one that is accepted
    bool is_accepted = false;  ///< by all error guards

    const MergedPlace& place() const { return places[next]; }
    bool is_open() const { return !is_accepted && next < places.size(); }

   private:
    friend class PairsAtOnce;
    std::vector<ErrorLook> looks_{};  ///< one a guard
    bool has_begun_ = false;
    std::size_t refuser_ = 0;  ///< of the place looked at last
  };

  PairsAtOnce(TriangleComplex& complex, const StageLimits& limits, unsigned threads);

  /// Whether there are error guards at all.
  bool any() const { return !guards_.empty(); }
  void clear();
  std::size_t most() const { return most_; }
  bool is_full() const { return n_ >= most_; }
  std::span<Entry> entries() { return std::span(entries_).first(n_); }

  /// Whether the pair and its neighbours are none of another pair's.
  bool is_apart(const ContractionProfile& profile);
  /// \pre `is_apart` was asked last of this pair, and true \param places not empty, tried in order
  void add(const RankedPair& ranked, const ContractionProfile& profile, std::span<const MergedPlace> places);
  /// Has the guards look at each pair at its next places, until one is accepted.
  void look();
  /// Where the merged vertex of a pair may rather be than at its places, all of which were refused.
  std::vector<Vec3> nearer_positions(const Entry& entry) const;
  /// Whether an accepted pair may still be contracted, after pairs before it were.
  bool still_accepts(Entry& entry);
  void note(const Change& change, const Entry& entry);

 private:
  template <class Work>
  void for_each_open(const Work& work);
  void look_at(Entry& entry);

  TriangleComplex& complex_;
  std::vector<std::unique_ptr<ErrorGuard>> guards_;
  ThreadPool thread_pool_;
  std::vector<Entry> entries_;  ///< the list may be longer than what is used of it
  std::size_t n_ = 0;
  std::size_t most_ = 0;
  std::vector<Entry*> open_;     ///< scratch
  std::vector<Index> closed_;    ///< the pair asked for last, and its neighbours
  std::vector<Index> taken_by_;  ///< per vertex, the round in which it was one of a pair or its neighbour
  Index round_ = 0;
};

}  // namespace whittle
