// Welding takes two steps. The first takes all candidates at a position for one vertex, and finds the faces at each
// edge. An edge that gets a third face by this is *doubtful*, and so are the positions at its ends. Elsewhere welding
// is done. The second step starts with separate vertices at doubtful positions, and `WeldResolver` joins them.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>

#include "repair/duplicate_faces.hh"
#include "repair/weld_resolver.hh"
#include "whittle/core/detail/drop.hh"
#include "whittle/core/detail/index_lists.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

namespace {

// Why a face is dropped.
constexpr char dropped_as_duplicate = 1;
constexpr char dropped_as_degenerate = 2;

struct EdgeEnd {
  Index higher;
  Index face;
  auto operator<=>(const EdgeEnd&) const = default;
};

// Calls visit(lower, higher, faces) for every edge of the chosen faces. Edges and faces ascend. Three edges per face
// may be more than `Index` can count.
template <class Choose, class Visit>
void for_each_edge(const std::vector<Triangle>& faces, std::size_t vertices, const Choose& is_chosen,
                   const Visit& visit) {
  detail::IndexLists<EdgeEnd, std::size_t> by_lower(vertices, [&](const auto& emit) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!is_chosen(f)) continue;
      const Triangle& t = faces[f];
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [lower, higher] = std::minmax(t[c], t[(c + 1) % 3]);
        emit(lower, EdgeEnd{higher, static_cast<Index>(f)});
      }
    }
  });
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::span<EdgeEnd> ends = by_lower.of(static_cast<Index>(v));
    std::sort(ends.begin(), ends.end());
    for (std::size_t first = 0; first < ends.size();) {
      std::size_t last = first + 1;
      while (last < ends.size() && ends[last].higher == ends[first].higher) ++last;
      visit(static_cast<Index>(v), ends[first].higher, std::span<const EdgeEnd>(ends.subspan(first, last - first)));
      first = last;
    }
  }
}

std::vector<std::uint8_t> count_uses_up_to_two(const IndexedMesh& mesh) {
  std::vector<std::uint8_t> uses(mesh.positions.size(), 0);
  for (const Triangle& face : mesh.faces) {
    if (!has_three_corners(face)) continue;
    for (const Index v : face) uses[v] = static_cast<std::uint8_t>(std::min(uses[v] + 1, 2));
  }
  return uses;
}

// Flags the vertices that may be welded: those on open borders, and the ends of edges without length. The faces at an
// edge without length have no area; welding makes them degenerate.
std::vector<char> find_candidates(const IndexedMesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  const std::vector<std::uint8_t> uses = count_uses_up_to_two(mesh);
  std::vector<char> is_candidate(vertices, 0);
  // An edge has two faces only if both its ends have. A soup has no such edge.
  detail::IndexLists<Index, std::size_t> by_lower(vertices, [&](const auto& emit) {
    for (const Triangle& t : mesh.faces) {
      if (!has_three_corners(t)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [lower, higher] = std::minmax(t[c], t[(c + 1) % 3]);
        if (uses[lower] > 1 && uses[higher] > 1) {
          emit(lower, higher);
        } else {
          is_candidate[lower] = is_candidate[higher] = 1;
        }
      }
    }
  });
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::span<Index> ends = by_lower.of(static_cast<Index>(v));
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const bool is_alone = (i == 0 || ends[i - 1] != ends[i]) && (i + 1 == ends.size() || ends[i + 1] != ends[i]);
      const bool has_no_length = mesh.positions[v] == mesh.positions[ends[i]];
      if (is_alone || has_no_length) is_candidate[v] = is_candidate[ends[i]] = 1;
    }
  }
  return is_candidate;
}

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i) {
    hash ^= std::bit_cast<std::uint64_t>(p[i] + 0.0);  // −0.0 becomes 0.0
    hash *= 0x9E3779B97F4A7C15U;                       // 2⁶⁴ over the golden ratio (Knuth, TAOCP 3, 6.4)
    hash ^= hash >> 32;
  }
  return hash;
}

// For each candidate, the lowest candidate at its position. For any other vertex, itself.
std::vector<Index> group_by_position(const std::vector<Vec3>& positions, const std::vector<char>& is_candidate) {
  std::vector<Index> group(positions.size());
  std::iota(group.begin(), group.end(), Index{0});
  const auto members = static_cast<std::size_t>(std::count(is_candidate.begin(), is_candidate.end(), 1));
  const std::size_t slots = std::bit_ceil(2 * members + 1);
  std::vector<Index> table(slots, invalid_index);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!is_candidate[v]) continue;
    std::size_t slot = hash_of(positions[v]) & (slots - 1);
    while (table[slot] != invalid_index && positions[table[slot]] != positions[v]) slot = (slot + 1) & (slots - 1);
    if (table[slot] == invalid_index) table[slot] = static_cast<Index>(v);
    group[v] = table[slot];
  }
  return group;
}

std::vector<Triangle> renumber(const std::vector<Triangle>& faces, const std::vector<Index>& number) {
  std::vector<Triangle> renumbered(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < 3; ++c) renumbered[f][c] = number[faces[f][c]];
  }
  return renumbered;
}

// The ends of an edge as a face stores them. \param a, b the ends by position.
std::array<Index, 2> stored_edge(const Triangle& stored, const Triangle& grouped, Index a, Index b) {
  std::array<Index, 2> ends{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (grouped[c] == a) ends[0] = stored[c];
    if (grouped[c] == b) ends[1] = stored[c];
  }
  return ends;
}

// Whether welding gives the edge a third face: it has more than two faces, and these have different edges in the mesh
// as stored.
bool is_doubtful(const IndexedMesh& mesh, const std::vector<Triangle>& grouped, Index a, Index b,
                 std::span<const EdgeEnd> faces) {
  if (faces.size() <= 2) return false;
  const auto first = stored_edge(mesh.faces[faces[0].face], grouped[faces[0].face], a, b);
  return std::any_of(faces.begin() + 1, faces.end(), [&](const EdgeEnd& end) {
    return stored_edge(mesh.faces[end.face], grouped[end.face], a, b) != first;
  });
}

// Flags the positions at the ends of doubtful edges. \param is_chosen tells the faces to look at.
template <class Choose>
std::vector<char> find_doubtful_groups(const IndexedMesh& mesh, const std::vector<Triangle>& grouped,
                                       const Choose& is_chosen) {
  std::vector<char> is_doubtful_group(mesh.positions.size(), 0);
  for_each_edge(grouped, mesh.positions.size(), is_chosen, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    if (is_doubtful(mesh, grouped, a, b, faces)) is_doubtful_group[a] = is_doubtful_group[b] = 1;
  });
  return is_doubtful_group;
}

bool has_any(const std::vector<char>& flags) { return std::find(flags.begin(), flags.end(), 1) != flags.end(); }

// Joins the ends of a face's edges without length, where their position is doubtful.
void join_ends_without_length(WeldResolver& resolver, const std::vector<char>& is_doubtful_group,
                              const Triangle& stored, const Triangle& grouped) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t next = (c + 1) % 3;
    const bool is_doubtful_end = grouped[c] == grouped[next] && is_doubtful_group[grouped[c]];
    if (is_doubtful_end) resolver.join(stored[c], stored[next]);
  }
}

// Joins vertices at doubtful positions as far as no edge gets a third face. `group` becomes the lowest vertex of each
// joined set.
template <class Choose>
void resolve_doubtful(const IndexedMesh& mesh, const std::vector<Triangle>& grouped,
                      const std::vector<char>& is_doubtful_group, const Choose& is_chosen, std::vector<Index>& group) {
  const std::size_t vertices = mesh.positions.size();
  WeldResolver resolver;
  for (std::size_t v = 0; v < vertices; ++v) {
    if (is_doubtful_group[group[v]]) resolver.add_vertex(static_cast<Index>(v));
  }
  for_each_edge(grouped, vertices, is_chosen, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    if (!is_doubtful(mesh, grouped, a, b, faces)) return;
    resolver.begin_edge();
    for (const EdgeEnd& end : faces) {
      const Triangle& face = grouped[end.face];
      const auto corner = static_cast<std::size_t>(std::find(face.begin(), face.end(), a) - face.begin());
      resolver.add_face(stored_edge(mesh.faces[end.face], face, a, b), face[(corner + 1) % 3] == b);
    }
  });
  for_each_edge(grouped, vertices, is_chosen, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    if (faces.size() != 2) return;
    const auto first = stored_edge(mesh.faces[faces[0].face], grouped[faces[0].face], a, b);
    const auto second = stored_edge(mesh.faces[faces[1].face], grouped[faces[1].face], a, b);
    if (is_doubtful_group[a]) resolver.join(first[0], second[0]);
    if (is_doubtful_group[b]) resolver.join(first[1], second[1]);
  });
  for (std::size_t f = 0; f < grouped.size(); ++f) {
    if (!has_three_corners(grouped[f]))
      join_ends_without_length(resolver, is_doubtful_group, mesh.faces[f], grouped[f]);
  }
  resolver.join_open_edges();
  for (std::size_t v = 0; v < vertices; ++v) {
    if (is_doubtful_group[group[v]]) group[v] = resolver.lowest_joined(static_cast<Index>(v));
  }
}

// Some faces were dropped because two corners are at one position, but these corners stayed apart. Such a face closes
// the surface there. It comes back unless it would be the third face of an edge.
void bring_back(const IndexedMesh& mesh, const std::vector<Index>& group, std::vector<char>& is_dropped) {
  const std::vector<Triangle> welded = renumber(mesh.faces, group);
  std::vector<char> is_back(welded.size(), 0);
  for (std::size_t f = 0; f < welded.size(); ++f) {
    is_back[f] = is_dropped[f] == dropped_as_degenerate && has_three_corners(welded[f]);
  }
  if (!has_any(is_back)) return;
  for (std::size_t f = 0; f < welded.size(); ++f) {
    if (is_back[f]) is_dropped[f] = 0;
  }
  for_each_edge(
      welded, mesh.positions.size(), [&](std::size_t f) { return !is_dropped[f] && has_three_corners(welded[f]); },
      [&](Index a, Index b, std::span<const EdgeEnd> faces) {
        if (!is_doubtful(mesh, welded, a, b, faces)) return;
        for (const EdgeEnd& end : faces) {
          if (is_back[end.face]) is_dropped[end.face] = dropped_as_degenerate;
        }
      });
}

std::size_t count_welded(const std::vector<Index>& group) {
  std::size_t welded = 0;
  for (std::size_t v = 0; v < group.size(); ++v) welded += group[v] != v;
  return welded;
}

// Flags the faces that welding may change: those with a corner that isn't alone at its position.
std::vector<char> find_touched_faces(const std::vector<Triangle>& faces, const std::vector<Index>& group) {
  std::vector<char> is_shared(group.size(), 0);
  for (std::size_t v = 0; v < group.size(); ++v) {
    if (group[v] != v) is_shared[v] = is_shared[group[v]] = 1;
  }
  std::vector<char> is_touched(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    is_touched[f] = static_cast<char>(is_shared[faces[f][0]] | is_shared[faces[f][1]] | is_shared[faces[f][2]]);
  }
  return is_touched;
}

}  // namespace

Repairs weld_borders(IndexedMesh& mesh, std::vector<Index>* joined_to) {
  Repairs done;
  if (joined_to != nullptr) joined_to->clear();
  std::vector<Index> group = group_by_position(mesh.positions, find_candidates(mesh));
  done.welded_vertices = count_welded(group);
  if (done.welded_vertices == 0) return done;

  const std::vector<Triangle> grouped = renumber(mesh.faces, group);
  const std::vector<char> is_touched = find_touched_faces(mesh.faces, group);
  const auto counts = [&](std::size_t f) { return is_touched[f] && has_three_corners(grouped[f]); };
  if (!has_any(find_doubtful_groups(mesh, grouped, counts))) {
    mesh.faces = grouped;
    if (joined_to != nullptr) *joined_to = std::move(group);
    return done;
  }

  // A duplicate of a face would make all edges of the face doubtful.
  std::vector<char> is_dropped = find_duplicate_faces(grouped, mesh.positions.size());
  for (std::size_t f = 0; f < grouped.size(); ++f) {
    if (!has_three_corners(grouped[f])) is_dropped[f] = dropped_as_degenerate;
  }
  const auto still_counts = [&](std::size_t f) { return is_touched[f] && !is_dropped[f]; };
  const std::vector<char> is_doubtful_group = find_doubtful_groups(mesh, grouped, still_counts);
  resolve_doubtful(mesh, grouped, is_doubtful_group, still_counts, group);
  bring_back(mesh, group, is_dropped);

  done.welded_vertices = count_welded(group);
  done.degenerate_faces =
      static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), dropped_as_degenerate));
  done.duplicate_faces =
      static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), dropped_as_duplicate));
  mesh.faces = renumber(mesh.faces, group);
  drop_faces(mesh, [&](std::size_t f) { return is_dropped[f] != 0; });
  if (joined_to != nullptr && done.welded_vertices > 0) *joined_to = std::move(group);
  return done;
}

}  // namespace whittle::io
