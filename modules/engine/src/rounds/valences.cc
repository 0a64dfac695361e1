#include "rounds/valences.hh"

#include <utility>

namespace whittle {

ValenceChange Valences::change(const VertexPair& pair) const {
  const Valence& a = of_vertices_[pair.a];
  const Valence& b = of_vertices_[pair.b];
  ValenceChange change;
  int n_opposite = 0;
  Index last = invalid_index;
  const auto look_at_opposite = [&](Index v) {
    if (v == std::exchange(last, v)) return;  // of two faces on the same corners
    ++n_opposite;
    if (!is_known(v)) return;
    const auto& [n, is_on_border] = of_vertices_[v];
    change.add_before(n, is_on_border);
    change.add_after(n - 1, is_on_border);
  };
  for (const LinkEdge& face : mesh_.star(pair.a)) {
    const Index x = mesh_.now(face.x);
    const Index y = mesh_.now(face.y);
    if (x == y) continue;
    if (x == pair.b) look_at_opposite(y);
    if (y == pair.b) look_at_opposite(x);
  }
  change.add_before(a.n, a.is_on_border);
  change.add_before(b.n, b.is_on_border);
  change.add_after(a.n + b.n - 2 - n_opposite, a.is_on_border || b.is_on_border);
  return change;
}

void Valences::merge(const VertexPair& pair, Index survivor, std::span<const Index> opposites) {
  if (!count()) return;
  const Valence a = of_vertices_[pair.a];
  const Valence b = of_vertices_[pair.b];
  int n_opposite = 0;
  Index last = invalid_index;
  for (const Index v : opposites) {
    if (v == std::exchange(last, v)) continue;  // of two faces on the same corners
    ++n_opposite;
    if (is_known(v)) --of_vertices_[v].n;
  }
  of_vertices_[survivor] = {a.n + b.n - 2 - n_opposite, a.is_on_border || b.is_on_border};
}

}  // namespace whittle
