#include "complex/triangle_complex.hh"

// How the faces at a vertex hang together.

namespace whittle {

Index TriangleComplex::place_in_link(Index v) {
  Index& place = link_place_[v];
  if (place < link_.size() && link_[place].vertex == v) return place;
  place = static_cast<Index>(link_.size());
  link_.push_back({.vertex = v});
  return place;
}

/// \param faces those at one vertex
void TriangleComplex::gather_link(std::span<const Wings::Wing> faces) {
  link_.clear();
  const auto connect = [&](Index from, Index to) {
    LinkEntry& entry = link_[from];
    if (entry.n_faces[0] < 2) entry.next[entry.n_faces[0]] = to;
    ++entry.n_faces[0];
  };
  for (const auto& [x, y] : faces) {
    const Index at_x = place_in_link(x);
    const Index at_y = place_in_link(y);
    connect(at_x, at_y);
    connect(at_y, at_x);
    ++link_[at_x].n_ahead;
    link_[at_x].ahead = at_y;
  }
}

VertexOrder TriangleComplex::order_of_link() const {
  std::size_t n_ends = 0;
  Index start = 0;
  for (Index i = 0; i < link_.size(); ++i) {
    if (link_[i].n_faces[0] > 2) return VertexOrder::junction;
    if (link_[i].n_faces[0] == 1) {
      ++n_ends;
      start = i;
    }
  }
  if (link_.empty()) return VertexOrder::regular;
  if (n_ends != 0 && n_ends != 2) return VertexOrder::junction;
  // The link is a union of closed polygons and at most one open one: a single one if a walk along it meets them all.
  std::size_t n_met = 1;
  Index previous = start;
  Index here = link_[start].next[0];
  while (here != start) {
    ++n_met;
    const Index beyond = link_[here].beyond(previous);
    if (beyond == invalid_index) break;
    previous = here;
    here = beyond;
  }
  if (n_met != link_.size()) return VertexOrder::junction;
  return n_ends == 0 ? VertexOrder::regular : VertexOrder::line;
}

/// Of a closed polygon: whether all faces run the same way along it.
bool TriangleComplex::is_link_oriented() const {
  return std::all_of(link_.begin(), link_.end(), [](const LinkEntry& entry) { return entry.n_ahead == 1; });
}

/// The vertex at `place` of an oriented polygon; goes on to the next, counter-clockwise.
Index TriangleComplex::step_along_link(Index& place) const {
  const LinkEntry& here = link_[place];
  place = here.ahead;
  return here.vertex;
}

}  // namespace whittle
