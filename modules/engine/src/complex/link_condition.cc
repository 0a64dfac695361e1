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

/// The link of a pair, gathered: the opposite vertices come first.
/// \return false if two faces are on the same three corners: that corner may have no others
bool gather_link(Link& link, const ContractionProfile& profile) {
  link.clear();
  const auto count_faces = [&](const StarFaces& faces, std::size_t side) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      ++link[link.slot(faces[i].x)].n_faces[side];
      ++link[link.slot(faces[i].y)].n_faces[side];
    }
  };
  for (const ContractionProfile::Common& opposite : profile.opposites) {
    Link::Entry& entry = link[link.slot(opposite.vertex)];
    if (entry.is_opposite) return false;
    entry.is_opposite = true;
    ++entry.n_faces[0];
    ++entry.n_faces[1];
  }
  count_faces(profile.first, 0);
  count_faces(profile.second, 1);
  return true;
}

/// Whether two faces, one at each vertex, lie over the same edge of the link, so that they would coincide: a
/// tetrahedron.
bool would_coincide(Link& link, const ContractionProfile& profile) {
  const auto is_opposite = [&](Index v) { return link[link.slot(v)].is_opposite; };
  for (std::size_t i = 0; i < profile.first.size(); ++i) {
    const auto [x, y] = profile.first[i];
    if (!is_opposite(x) || !is_opposite(y)) continue;
    for (std::size_t j = 0; j < profile.second.size(); ++j) {
      const auto [p, q] = profile.second[j];
      if (std::minmax(p, q) == std::minmax(x, y)) return true;
    }
  }
  return false;
}

bool holds(TriangleComplex& complex, const ContractionProfile& profile) {
  const auto& [id, a, b] = profile.pair;
  const std::size_t n_opposite = profile.opposites.size();
  if (n_opposite == 0) return false;                                  // not an edge
  if (profile.first.empty() && profile.second.empty()) return false;  // the part would vanish
  Link& link = complex.link();
  if (!gather_link(link, profile)) return false;
  // A common neighbour that makes no face with the pair: a tunnel or a fold would close.
  const auto is_common = [](const Link::Entry& entry) { return entry.n_faces[0] != 0 && entry.n_faces[1] != 0; };
  const std::span<const Link::Entry> entries = link.entries();
  if (std::any_of(entries.begin() + static_cast<std::ptrdiff_t>(n_opposite), entries.end(), is_common)) return false;
  if (would_coincide(link, profile)) return false;
  // The cone vertex over irregular edges: two such vertices may only merge along such an edge, not when a third one
  // makes a triangle of such edges with them (a hole of three edges, a lone face), and not when both are junctions.
  if (complex.kind(a) == VertexKind::regular || complex.kind(b) == VertexKind::regular) return true;
  if (n_opposite == 2) return false;
  if (complex.kind(a) == VertexKind::junction && complex.kind(b) == VertexKind::junction) return false;
  const std::span<const Link::Entry> opposites = link.entries().first(n_opposite);
  return std::none_of(opposites.begin(), opposites.end(),
                      [](const Link::Entry& entry) { return entry.n_faces[0] != 2 && entry.n_faces[1] != 2; });
}

}  // namespace

bool link_condition(TriangleComplex& complex, const ContractionProfile& profile) {
  return obviously_holds(complex, profile) || holds(complex, profile);
}

}  // namespace whittle
