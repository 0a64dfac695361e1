#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "complex/triangle_complex.hh"

// Walks over the faces at vertices whose lists are compact, in an order by original vertex numbers: that which sums
// over them have.

namespace whittle {

/// The other corners of a face at a vertex, in its order.
using OtherCorners = std::pair<Index, Index>;

/// Those of the faces at an irregular vertex, sorted.
inline std::vector<OtherCorners> sorted_corners(const TriangleComplex& complex, Index v) {
  std::vector<OtherCorners> corners;
  const std::span<const Neighbour> list = complex.neighbours(v);
  for (std::size_t i = 0; i < list.size(); i += 2) corners.emplace_back(list[i].vertex, list[i + 1].vertex);
  const auto key = [&](const OtherCorners& c) { return std::pair(complex.origin(c.first), complex.origin(c.second)); };
  std::sort(corners.begin(), corners.end(),
            [&](const OtherCorners& x, const OtherCorners& y) { return key(x) < key(y); });
  return corners;
}

/// Puts sorted corners that are a ring of one orientation in the order of that, those of the lowest number first;
/// leaves others as they are. The list of a vertex whose faces once had several orientations stays one of pairs.
inline void order_as_ring(std::vector<OtherCorners>& corners) {
  std::vector<OtherCorners> ring{corners.front()};
  while (ring.back().second != ring.front().first) {
    const auto follows = [&](const OtherCorners& face) { return face.first == ring.back().second; };
    const auto next = std::find_if(corners.begin(), corners.end(), follows);
    if (next == corners.end() || ring.size() == corners.size()) return;
    ring.push_back(*next);
  }
  if (ring.size() == corners.size()) corners = std::move(ring);
}

/// Those of the faces at an irregular vertex, in the order in which they are walked over.
inline std::vector<OtherCorners> ordered_corners(const TriangleComplex& complex, Index v) {
  std::vector<OtherCorners> corners = sorted_corners(complex, v);
  if (complex.kind(v) == VertexKind::regular && !corners.empty()) order_as_ring(corners);
  return corners;
}

/// Where the lowest original number of a ring is.
inline std::size_t lowest_place(const TriangleComplex& complex, std::span<const Neighbour> ring) {
  std::size_t place = 0;
  Index lowest = complex.origin(ring[0].vertex);
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const Index origin = complex.origin(ring[i].vertex);
    const bool is_lower = origin < lowest;
    place = is_lower ? i : place;
    lowest = is_lower ? origin : lowest;
  }
  return place;
}

/// The neighbours of an irregular vertex, each once: of a ring the corners y of its faces as walked over, else sorted.
inline std::vector<Index> ordered_neighbours(const TriangleComplex& complex, Index v) {
  const std::vector<OtherCorners> corners = ordered_corners(complex, v);
  std::vector<Index> neighbours;
  bool is_ring = true;
  Index last = corners.empty() ? invalid_index : corners.back().second;
  for (const auto& [x, y] : corners) {
    is_ring = is_ring && x == last;
    last = y;
    neighbours.push_back(y);
  }
  if (is_ring) return neighbours;
  for (const auto& [x, y] : corners) neighbours.push_back(x);
  const auto is_before = [&](Index x, Index y) { return complex.origin(x) < complex.origin(y); };
  std::sort(neighbours.begin(), neighbours.end(), is_before);
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  return neighbours;
}

/// Calls `use(c, turn)` for each face of v and w by its third corner c; turn is 1 where the face is (v, w, c), −1 where
/// it is (v, c, w). Of the same corner those of turn 1 come first.
template <class Use>
void for_each_common_face(const TriangleComplex& complex, Index v, Index w, const Use& use) {
  if (!complex.is_ring(v)) {
    std::vector<std::pair<Index, int>> thirds;
    for (const auto& [x, y] : sorted_corners(complex, v)) {
      if (x == w) thirds.emplace_back(y, 1);
      if (y == w) thirds.emplace_back(x, -1);
    }
    const auto key = [&](const auto& third) { return std::pair(complex.origin(third.first), -third.second); };
    std::sort(thirds.begin(), thirds.end(), [&](const auto& c, const auto& d) { return key(c) < key(d); });
    for (const auto& [c, turn] : thirds) use(c, turn);
    return;
  }
  const std::span<const Neighbour> ring = complex.neighbours(v);
  const auto place =
      std::find_if(ring.begin(), ring.end(), [w](const Neighbour& neighbour) { return neighbour.vertex == w; });
  if (place == ring.end()) return;
  const Index previous = (place == ring.begin() ? ring.back() : *(place - 1)).vertex;
  const Index next = (place + 1 == ring.end() ? ring.front() : *(place + 1)).vertex;
  const bool previous_is_first = complex.origin(previous) < complex.origin(next);
  if (previous_is_first) use(previous, -1);
  use(next, 1);
  if (!previous_is_first) use(previous, -1);
}

}  // namespace whittle
