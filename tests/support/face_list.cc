#include "support/face_list.hh"

#include <algorithm>

namespace whittle::test {

std::map<Edge, int> count_edge_faces(std::span<const Triangle> faces) {
  std::map<Edge, int> counts;
  for (const Triangle& f : faces) {
    for (std::size_t i = 0; i < 3; ++i) ++counts[edge(f[i], f[(i + 1) % 3])];
  }
  return counts;
}

int n_pieces(const Link& link) {
  std::map<Index, Index> piece;
  for (const Index v : link.vertices) piece[v] = v;
  const auto find = [&](Index v) {
    while (piece[v] != v) v = piece[v];
    return v;
  };
  for (const auto& [a, b] : link.edges) piece[find(a)] = find(b);
  return static_cast<int>(std::ranges::count_if(piece, [](const auto& entry) { return entry.first == entry.second; }));
}

Link link_of(Index v, std::span<const Triangle> faces) {
  Link link;
  std::map<Index, int> n_faces;
  for (const Triangle& f : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (f[i] != v) continue;
      const Index x = f[(i + 1) % 3];
      const Index y = f[(i + 2) % 3];
      link.edges.insert(edge(x, y));
      ++n_faces[x];
      ++n_faces[y];
    }
  }
  bool is_line = true;
  for (const auto& [w, n] : n_faces) {
    link.vertices.insert(w);
    if (n != 2) link.irregular.insert(w);
    if (n > 2) is_line = false;
  }
  const bool is_one_fan = n_pieces(link) <= 1;
  const bool is_regular = link.irregular.empty() && is_one_fan;
  link.is_singular = !is_regular && !(is_line && is_one_fan && link.irregular.size() == 2);
  if (!is_regular) {
    link.vertices.insert(invalid_index);
    for (const Index w : link.irregular) link.edges.insert(edge(w, invalid_index));
  }
  return link;
}

}  // namespace whittle::test
