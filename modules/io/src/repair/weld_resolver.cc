#include "repair/weld_resolver.hh"

#include <algorithm>
#include <utility>

namespace whittle::io {

void WeldResolver::add_vertex(Index vertex) {
  const auto set = static_cast<Set>(parent_.size());
  set_of_.emplace(vertex, set);
  parent_.push_back(set);
  lowest_.push_back(vertex);
  uses_.emplace_back();
}

void WeldResolver::add_face(const std::array<Index, 2>& ends, bool forward, const Vec3& normal) {
  const auto edge = static_cast<std::uint32_t>(edges_.size() - 1);
  const auto face = static_cast<std::uint32_t>(edges_.back().size());
  edges_.back().push_back({{set_of_.at(ends[0]), set_of_.at(ends[1])}, forward, normal});
  for (std::uint8_t end = 0; end < 2; ++end) uses_[set_of_.at(ends[end])].push_back({edge, face, end});
  ++faces_at_[actual_edge(edge, face)];
}

std::size_t WeldResolver::ActualEdgeHash::operator()(const ActualEdge& e) const {
  std::uint64_t hash = e.edge;
  for (const std::uint64_t part : {std::uint64_t{e.low}, std::uint64_t{e.high}}) {
    hash = (hash ^ part) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 32;
  }
  return hash;
}

WeldResolver::Set WeldResolver::find(Set set) const {
  while (parent_[set] != set) set = parent_[set] = parent_[parent_[set]];
  return set;
}

WeldResolver::ActualEdge WeldResolver::actual_edge(std::uint32_t edge, std::uint32_t face) const {
  const Face& f = edges_[edge][face];
  return {edge, find(f.ends[0]), find(f.ends[1])};
}

bool WeldResolver::is_open(std::uint32_t edge, std::uint32_t face) const {
  return faces_at_.at(actual_edge(edge, face)) == 1;
}

// \pre a and b are different sets, and b has no more uses than a.
bool WeldResolver::can_join(Set a, Set b) const {
  return std::none_of(uses_[b].begin(), uses_[b].end(), [&](const Use& use) {
    const ActualEdge edge = actual_edge(use.edge, use.face);
    ActualEdge joined = edge;
    (use.end == 0 ? joined.low : joined.high) = a;
    const auto found = faces_at_.find(joined);
    return found != faces_at_.end() && found->second + faces_at_.at(edge) > 2;
  });
}

bool WeldResolver::join_sets(Set a, Set b) {
  if (a == b) return true;
  if (uses_[a].size() < uses_[b].size()) std::swap(a, b);  // Moving the smaller set costs n log n in all.
  if (!can_join(a, b)) return false;
  for (const Use& use : uses_[b]) {
    const ActualEdge edge = actual_edge(use.edge, use.face);
    const auto found = faces_at_.find(edge);
    if (--found->second == 0) faces_at_.erase(found);
    to_follow_.push_back(use.edge);
  }
  parent_[b] = a;
  lowest_[a] = std::min(lowest_[a], lowest_[b]);
  for (const Use& use : uses_[b]) ++faces_at_[actual_edge(use.edge, use.face)];
  uses_[a].insert(uses_[a].end(), uses_[b].begin(), uses_[b].end());
  uses_[b] = {};
  return true;
}

bool WeldResolver::join(Index a, Index b) { return join_sets(find(set_of_.at(a)), find(set_of_.at(b))); }

bool WeldResolver::lie_on_each_other(std::uint32_t edge, std::uint32_t f, std::uint32_t g) const {
  const Face& face = edges_[edge][f];
  const Face& other = edges_[edge][g];
  const double cosine = face.normal.dot(other.normal);
  return (face.forward == other.forward ? cosine : -cosine) > 1 - 1e-6;
}

// Joins both ends of two faces, or neither if one end can't be joined. Joining the first end may rule out the second:
// it is checked again.
bool WeldResolver::try_pair(std::uint32_t edge, std::uint32_t f, std::uint32_t g) {
  const ActualEdge at_f = actual_edge(edge, f);
  const ActualEdge at_g = actual_edge(edge, g);
  const auto is_possible = [&](Set a, Set b) {
    if (a == b) return true;
    return uses_[a].size() < uses_[b].size() ? can_join(b, a) : can_join(a, b);
  };
  if (!is_possible(at_f.low, at_g.low) || !is_possible(at_f.high, at_g.high)) return false;
  return join_sets(at_f.low, at_g.low) && join_sets(at_f.high, at_g.high);
}

void WeldResolver::pair_faces(std::uint32_t edge, bool need_common_end) {
  constexpr std::size_t most_faces =
      16;  // No real surface has more at an edge. Without the limit, a hostile file costs n².
  const auto count = static_cast<std::uint32_t>(edges_[edge].size());
  if (count > most_faces) return;
  for (const bool same_way : {false, true}) {
    for (std::uint32_t f = 0; f < count; ++f) {
      for (std::uint32_t g = f + 1; g < count && is_open(edge, f); ++g) {
        if ((edges_[edge][f].forward == edges_[edge][g].forward) != same_way || !is_open(edge, g)) continue;
        if (!folds_ && lie_on_each_other(edge, f, g)) continue;
        const ActualEdge at_f = actual_edge(edge, f);
        const ActualEdge at_g = actual_edge(edge, g);
        if (!need_common_end || at_f.low == at_g.low || at_f.high == at_g.high) try_pair(edge, f, g);
      }
    }
  }
}

// Joining at one edge gives faces at the next edge a common end: a decision settles a whole line of doubtful edges.
void WeldResolver::follow() {
  while (!to_follow_.empty()) {
    const std::uint32_t edge = to_follow_.back();
    to_follow_.pop_back();
    pair_faces(edge, true);
  }
}

void WeldResolver::join_open_edges(bool folds) {
  folds_ = folds;
  const auto count = static_cast<std::uint32_t>(edges_.size());
  to_follow_.clear();
  for (std::uint32_t edge = 0; edge < count; ++edge) pair_faces(edge, true);
  follow();
  for (std::uint32_t edge = 0; edge < count; ++edge) {
    pair_faces(edge, false);
    follow();
  }
}

}  // namespace whittle::io
