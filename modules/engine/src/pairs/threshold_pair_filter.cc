#include "pairs/threshold_pair_filter.hh"

#include <algorithm>

namespace whittle {
namespace {

constexpr std::size_t n_known_bits = 13;

}  // namespace

ThresholdPairFilter::ThresholdPairFilter(TriangleComplex& complex)
    : complex_(complex),
      hidden_(complex.n_vertex_slots(), static_cast<Index>(complex.n_edges()),
              complex.n_pair_slots() - complex.n_edges()),
      known_(complex.has_threshold_pairs() ? std::size_t{1} << n_known_bits : 0, {0, invalid_index, invalid_index}) {}

void ThresholdPairFilter::apply(std::vector<Index>& pairs) {
  if (!complex_.has_threshold_pairs()) return;
  const auto is_edge = [this](Index id) { return !complex_.is_threshold_pair(id); };
  const auto first = std::partition(pairs.begin(), pairs.end(), is_edge);
  look_up_alive(std::span(first, pairs.end()));
  pairs.erase(first, pairs.end());
  for (std::size_t i = 0; i < alive_.size(); ++i) {
    if (i + 8 < alive_.size()) complex_.prefetch_list(alive_[i + 8].a);
    const Pair& pair = alive_[i];
    if (pair.a == pair.b || is_duplicate(pair)) {
      complex_.remove_pair(pair.id);
    } else if (!hides(pair)) {
      pairs.push_back(pair.id);
    }
  }
}

/// Lists the pairs that are alive, with their ends as they are now. Prefetches what is asked of them next.
void ThresholdPairFilter::look_up_alive(std::span<const Index> ids) {
  alive_.clear();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i + 16 < ids.size()) complex_.prefetch_pair(ids[i + 16]);
    if (i + 8 < ids.size()) complex_.prefetch_ends(ids[i + 8]);
    if (!complex_.is_pair_alive(ids[i])) continue;
    const auto [a, b] = complex_.ends(ids[i]);
    alive_.push_back({ids[i], a, b});
    complex_.prefetch_star(a);
  }
}

bool ThresholdPairFilter::hides(const Pair& pair) {
  if (!complex_.have_common_face(pair.a, pair.b)) return false;
  hidden_.add(pair.a, pair.id);
  return true;
}

/// Whether a pair has become equal to one that was seen lately. If not, remembers it. Merging vertices makes two edges
/// one, but not two threshold pairs.
bool ThresholdPairFilter::is_duplicate(const Pair& pair) {
  const auto [a, b] = std::minmax(pair.a, pair.b);
  constexpr std::uint64_t odd = 0x9E3779B97F4A7C15;
  Pair& known = known_[(std::uint64_t{a} * odd + b) * odd >> (64 - n_known_bits)];
  // If the other pair is alive, it still joins the same two vertices.
  const bool is_same = known.a == a && known.b == b && known.id != pair.id;
  if (is_same && complex_.is_pair_alive(known.id)) return true;
  known = {pair.id, a, b};
  return false;
}

}  // namespace whittle
