#include "complex/link_condition.hh"

#include <algorithm>

namespace whittle {
namespace {

/// The common case, without a look at any neighbour: an inner edge, and by a coarse look no common neighbour beside the
/// two opposite vertices. False only means that a closer look is due.
bool obviously_holds(const TriangleComplex& complex, const ContractionProfile& profile) {
  const StarFaces& first = profile.first;
  const StarFaces& second = profile.second;
  if (!complex.is_ring(profile.pair.a) || !complex.is_ring(profile.pair.b)) return false;
  if (profile.opposites.size() != 2) return false;
  // With one face each beside the common ones, both would lie over the same edge: a tetrahedron.
  if (first.size() < 2 && second.size() < 2) return false;
  if (first.empty() || second.empty()) return false;
  const auto between_opposites = [](const StarFaces& fan) { return fan.neighbours().subspan(1, fan.size() - 1); };
  // A bit for each vertex, by six bits of its number: first the lowest six, then, if those collide, the next.
  const auto are_apart = [&](unsigned shift) {
    const auto signature = [shift](std::span<const Neighbour> neighbours) {
      std::uint64_t bits = 0;
      for (const Neighbour& neighbour : neighbours) bits |= std::uint64_t{1} << (neighbour.vertex >> shift & 63);
      return bits;
    };
    return (signature(between_opposites(first)) & signature(between_opposites(second))) == 0;
  };
  return are_apart(0) || are_apart(6);
}

Index vertex_of(const ContractionProfile::Common& common) { return common.vertex; }
Index vertex_of(Index v) { return v; }

/// The faces of a pair, in lists of any kind.
template <class Faces, class Opposites>
struct PairLists {
  const Faces& first;
  const Faces& second;
  const Opposites& opposites;

  /// Gathers the link of the pair: the opposite vertices come first.
  /// \return false if two faces are on the same three corners: that corner may have no others
  bool gather(Link& link) const {
    link.clear();
    for (const auto& common : opposites) {
      Link::Entry& entry = link[link.slot(vertex_of(common))];
      if (entry.is_opposite) return false;
      entry.is_opposite = true;
      ++entry.n_faces[0];
      ++entry.n_faces[1];
    }
    count(first, 0, link);
    count(second, 1, link);
    return true;
  }

  /// Whether two faces, one at each vertex, lie over the same edge of the link, so that they would coincide: a
  /// tetrahedron.
  bool would_coincide(Link& link) const {
    const auto is_opposite = [&](Index v) { return link[link.slot(v)].is_opposite; };
    for (std::size_t i = 0; i < first.size(); ++i) {
      const auto [x, y] = first[i];
      if (!is_opposite(x) || !is_opposite(y)) continue;
      for (std::size_t j = 0; j < second.size(); ++j) {
        const auto [p, q] = second[j];
        if (std::minmax(p, q) == std::minmax(x, y)) return true;
      }
    }
    return false;
  }

 private:
  static void count(const Faces& faces, std::size_t side, Link& link) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      ++link[link.slot(faces[i].x)].n_faces[side];
      ++link[link.slot(faces[i].y)].n_faces[side];
    }
  }
};

template <class Faces, class Opposites>
PairLists(const Faces&, const Faces&, const Opposites&) -> PairLists<Faces, Opposites>;

template <class Faces, class Opposites>
bool holds(Link& link, const PairLists<Faces, Opposites>& pair, const std::array<VertexKind, 2>& kinds) {
  const std::size_t n_opposite = pair.opposites.size();
  if (n_opposite == 0) return false;                            // not an edge
  if (pair.first.empty() && pair.second.empty()) return false;  // the part would vanish
  if (!pair.gather(link)) return false;
  // A common neighbour that makes no face with the pair: a tunnel or a fold would close.
  const auto is_common = [](const Link::Entry& entry) { return entry.n_faces[0] != 0 && entry.n_faces[1] != 0; };
  const std::span<const Link::Entry> entries = link.entries();
  if (std::any_of(entries.begin() + static_cast<std::ptrdiff_t>(n_opposite), entries.end(), is_common)) return false;
  if (pair.would_coincide(link)) return false;
  // The cone vertex over irregular edges: two such vertices may only merge along such an edge, not when a third one
  // makes a triangle of such edges with them (a hole of three edges, a lone face), and not when both are junctions.
  if (kinds[0] == VertexKind::regular || kinds[1] == VertexKind::regular) return true;
  if (n_opposite == 2) return false;
  if (kinds[0] == VertexKind::junction && kinds[1] == VertexKind::junction) return false;
  const std::span<const Link::Entry> opposites = link.entries().first(n_opposite);
  return std::none_of(opposites.begin(), opposites.end(),
                      [](const Link::Entry& entry) { return entry.n_faces[0] != 2 && entry.n_faces[1] != 2; });
}

}  // namespace

bool link_condition(TriangleComplex& complex, const ContractionProfile& profile) {
  if (obviously_holds(complex, profile)) return true;
  const auto& [id, a, b] = profile.pair;
  return holds(complex.link(), PairLists{profile.first, profile.second, profile.opposites},
               {complex.kind(a), complex.kind(b)});
}

bool link_condition(Link& link, const PairFaces& faces) {
  return holds(link, PairLists{faces.first, faces.second, faces.opposites}, faces.kinds);
}

}  // namespace whittle
