#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "rounds/cost_counts.hh"
#include "rounds/star_planes.hh"
#include "whittle/core/vertex_pair.hh"

namespace whittle {

/// Makes a list long enough.
template <class T>
void make_room(std::vector<T>& list, std::size_t n) {
  if (list.size() < n) list.resize(n + n / 8);
}

/// Where some pairs stand in a list.
struct PairChunk {
  std::size_t begin, end;
};

/// What a part needs in a round and not from one round to the next. The lists may be longer than what is used of them.
struct RoundScratch {
  std::vector<StarPlanes> stars;  ///< per vertex
  // By vertex, its faces, of this round and of the next one
  std::array<std::vector<LinkEdge>, 2> corners;
  std::array<std::vector<Index>, 2> corner_faces;  ///< their numbers
  std::vector<VertexPair> pairs;                   ///< in chunks
  std::vector<PairChunk> chunks;
  std::vector<float> costs;       ///< per pair
  std::vector<Index> candidates;  ///< of the pairs, in the order of their turns
  std::vector<Index> places;      ///< in `candidates`, by class of cost
  CostCounts cost_counts;

  std::span<StarPlanes> stars_of(std::size_t n_vertices) {
    make_room(stars, n_vertices);
    return std::span(stars).first(n_vertices);
  }
};

/// Lends what some parts have used to others, for the system takes long to give memory.
class RoundScratchPool {
 public:
  std::unique_ptr<RoundScratch> take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) return std::make_unique<RoundScratch>();
    std::unique_ptr<RoundScratch> scratch = std::move(free_.back());
    free_.pop_back();
    return scratch;
  }
  void give_back(std::unique_ptr<RoundScratch> scratch) {
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(scratch));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<RoundScratch>> free_;
};

}  // namespace whittle
