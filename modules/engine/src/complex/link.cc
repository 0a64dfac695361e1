#include "complex/link.hh"

#include <algorithm>
#include <numeric>

namespace whittle {

Index Link::slot(Index v) {
  Index& slot = slots_[v];
  if (slot < entries_.size() && entries_[slot].vertex == v) return slot;
  slot = static_cast<Index>(entries_.size());
  entries_.push_back({.vertex = v});
  return slot;
}

void Link::gather(std::span<const Neighbour> pairs) {
  faces_.clear();
  for (std::size_t i = 0; i < pairs.size(); i += 2) faces_.push_back({pairs[i].vertex, pairs[i + 1].vertex});
  connect_faces();
}

void Link::gather(std::span<const LinkEdge> faces) {
  faces_.assign(faces.begin(), faces.end());
  connect_faces();
}

void Link::connect_faces() {
  entries_.clear();
  const auto connect = [&](Index from, Index to) {
    Entry& entry = entries_[from];
    if (entry.n_faces[0] < 2) entry.next[entry.n_faces[0]] = to;
    ++entry.n_faces[0];
  };
  for (const auto& [x, y] : faces_) {
    const Index at_x = slot(x);
    const Index at_y = slot(y);
    connect(at_x, at_y);
    connect(at_y, at_x);
    ++entries_[at_x].n_ahead;
    entries_[at_x].ahead = at_y;
  }
}

VertexKind Link::kind() const {
  std::size_t n_ends = 0;
  Index start = 0;
  for (Index i = 0; i < entries_.size(); ++i) {
    if (entries_[i].n_faces[0] > 2) return VertexKind::junction;
    if (entries_[i].n_faces[0] == 1) {
      ++n_ends;
      start = i;
    }
  }
  if (entries_.empty()) return VertexKind::regular;
  if (n_ends != 0 && n_ends != 2) return VertexKind::junction;
  // The link is a union of closed polygons and at most one open one: a single one if a walk along it meets them all.
  std::size_t n_met = 1;
  Index previous = start;
  Index here = entries_[start].next[0];
  while (here != start) {
    ++n_met;
    const Index beyond = entries_[here].beyond(previous);
    if (beyond == invalid_index) break;
    previous = here;
    here = beyond;
  }
  if (n_met != entries_.size()) return VertexKind::junction;
  return n_ends == 0 ? VertexKind::regular : VertexKind::line;
}

bool Link::is_oriented() const {
  return std::all_of(entries_.begin(), entries_.end(), [](const Entry& entry) { return entry.n_ahead == 1; });
}

Index Link::step(Index& slot) const {
  const Entry& here = entries_[slot];
  slot = here.ahead;
  return here.vertex;
}

std::size_t Link::n_fans() {
  fan_.resize(entries_.size());
  std::iota(fan_.begin(), fan_.end(), Index{0});
  const auto find = [this](Index i) {
    while (fan_[i] != i) i = fan_[i] = fan_[fan_[i]];
    return i;
  };
  std::size_t n = fan_.size();
  for (const auto& [x, y] : faces_) {
    const Index at_x = find(slot(x));
    const Index at_y = find(slot(y));
    n -= static_cast<std::size_t>(at_x != at_y);
    fan_[at_x] = at_y;
  }
  return n;
}

}  // namespace whittle
