// Welding takes two steps. The first takes all candidates at a position for one vertex, and finds the faces at each
// edge. An edge that gets a third face by this is *doubtful*, and so are the positions at its ends. Elsewhere welding
// is done. The second step starts with separate vertices at doubtful positions, and `WeldResolver` joins them: first
// faces that go on from one another, then a front and a back that lie on each other.
#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <utility>

#include "repair/duplicate_faces.hh"
#include "repair/weld.hh"
#include "repair/weld_resolver.hh"
#include "whittle/core/detail/drop.hh"
#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/detail/large_array.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/wedges.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

namespace {

// Why a face is dropped.
constexpr char dropped_as_duplicate = 1;
constexpr char dropped_as_degenerate = 2;

// Per vertex or face, 0 or 1.
using Flags = std::vector<std::uint8_t>;

// In most cases the first coordinate decides.
bool is_same_place(const Vec3& p, const Vec3& q) { return p.x() == q.x() && p.y() == q.y() && p.z() == q.z(); }

// Flags the vertices that may be welded: on open borders, or at the ends of edges without length. The faces at an edge
// without length have no area; welding makes them degenerate.
Flags find_candidates(const IndexedMesh& mesh, unsigned threads) {
  Flags is_candidate = whittle::detail::border_vertices(mesh.faces, mesh.positions.size(), threads);
  const auto mark = [&](Index v) { std::atomic_ref(is_candidate[v]).store(1, std::memory_order_relaxed); };
  for_each_range(mesh.faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Triangle& face = mesh.faces[f];
      if (!has_three_corners(face)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const Index a = face[c];
        const Index b = face[(c + 1) % 3];
        if (!is_same_place(mesh.positions[a], mesh.positions[b])) continue;
        mark(a);
        mark(b);
      }
    }
  });
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
std::vector<Index> group_by_position(const std::vector<Vec3>& positions, const Flags& is_candidate) {
  std::vector<Index> group;
  resize_large(group, positions.size());
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

std::vector<Triangle> renumber(const std::vector<Triangle>& faces, const std::vector<Index>& number, unsigned threads) {
  std::vector<Triangle> renumbered;
  resize_large(renumbered, faces.size());
  for_each_range(faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      renumbered[f] = {number[faces[f][0]], number[faces[f][1]], number[faces[f][2]]};
  });
  return renumbered;
}

// The ends of an edge as a face stores them. \param edge its ends by position
std::array<Index, 2> stored_edge(const Triangle& stored, const Triangle& grouped, const VertexPair& edge) {
  std::array<Index, 2> ends{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (grouped[c] == edge.a) ends[0] = stored[c];
    if (grouped[c] == edge.b) ends[1] = stored[c];
  }
  return ends;
}

// The edges by position, and how the mesh stores them.
class GroupedEdges {
 public:
  // \param is_chosen the faces to look at; all have three corners by position
  GroupedEdges(const IndexedMesh& mesh, const std::vector<Triangle>& grouped, const Flags& is_chosen)
      : mesh_(mesh), grouped_(grouped), edges_(grouped, mesh.positions.size(), is_chosen) {}

  std::size_t size() const { return edges_.size(); }
  const VertexPair& operator[](std::size_t edge) const { return edges_[edge]; }
  std::span<const Index> sides(std::size_t edge) const { return edges_.sides(edge); }
  // The ends of the edge as the face of one of its sides stores them.
  std::array<Index, 2> stored(std::size_t edge, Index side) const {
    const Index face = whittle::detail::face_of(side);
    return stored_edge(mesh_.faces[face], grouped_[face], edges_[edge]);
  }
  // Whether welding gives the edge a third face: it has more than two faces, and these have different edges in the mesh
  // as stored.
  bool is_doubtful(std::size_t edge) const {
    const std::span<const Index> all = sides(edge);
    if (all.size() <= 2) return false;
    const auto first = stored(edge, all[0]);
    return std::any_of(all.begin() + 1, all.end(), [&](Index side) { return stored(edge, side) != first; });
  }

 private:
  const IndexedMesh& mesh_;
  const std::vector<Triangle>& grouped_;
  whittle::detail::EdgeTable edges_;
};

// Flags the positions at the ends of doubtful edges.
Flags find_doubtful_groups(const GroupedEdges& edges, std::size_t n_vertices) {
  Flags is_doubtful_group(n_vertices);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.is_doubtful(e)) is_doubtful_group[edges[e].a] = is_doubtful_group[edges[e].b] = 1;
  }
  return is_doubtful_group;
}

bool has_any(const Flags& flags) { return std::find(flags.begin(), flags.end(), 1) != flags.end(); }

// Joins the ends of a face's edges without length, where their position is doubtful.
void join_ends_without_length(WeldResolver& resolver, const Flags& is_doubtful_group, const Triangle& stored,
                              const Triangle& grouped) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::size_t next = (c + 1) % 3;
    const bool is_doubtful_end = grouped[c] == grouped[next] && is_doubtful_group[grouped[c]];
    if (is_doubtful_end) resolver.join(stored[c], stored[next]);
  }
}

// The unit normal, or zero.
Vec3 normal_of(const IndexedMesh& mesh, Index face) {
  return area_normal(mesh.positions, mesh.faces[face]).stableNormalized();
}

void add_doubtful_edges(WeldResolver& resolver, const IndexedMesh& mesh, const GroupedEdges& edges,
                        const std::vector<Triangle>& grouped) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_doubtful(e)) continue;
    resolver.begin_edge();
    for (const Index side : edges.sides(e)) {
      resolver.add_face(edges.stored(e, side), whittle::detail::start_of(side, grouped) == edges[e].a,
                        normal_of(mesh, whittle::detail::face_of(side)));
    }
  }
}

// Joins the stored vertices of edges with two faces, where their position is doubtful.
void join_along_plain_edges(WeldResolver& resolver, const GroupedEdges& edges, const Flags& is_doubtful_group) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.sides(e).size() != 2) continue;
    const auto first = edges.stored(e, edges.sides(e)[0]);
    const auto second = edges.stored(e, edges.sides(e)[1]);
    if (is_doubtful_group[edges[e].a]) resolver.join(first[0], second[0]);
    if (is_doubtful_group[edges[e].b]) resolver.join(first[1], second[1]);
  }
}

// Joins vertices at doubtful positions as far as no edge gets a third face. `group` becomes the lowest vertex of each
// joined set.
void resolve_doubtful(const IndexedMesh& mesh, const std::vector<Triangle>& grouped, const Flags& is_chosen,
                      std::vector<Index>& group) {
  const std::size_t n_vertices = mesh.positions.size();
  const GroupedEdges edges(mesh, grouped, is_chosen);
  const Flags is_doubtful_group = find_doubtful_groups(edges, n_vertices);
  WeldResolver resolver;
  for (std::size_t v = 0; v < n_vertices; ++v) {
    if (is_doubtful_group[group[v]]) resolver.add_vertex(static_cast<Index>(v));
  }
  add_doubtful_edges(resolver, mesh, edges, grouped);
  join_along_plain_edges(resolver, edges, is_doubtful_group);
  for (std::size_t f = 0; f < grouped.size(); ++f) {
    if (!has_three_corners(grouped[f]))
      join_ends_without_length(resolver, is_doubtful_group, mesh.faces[f], grouped[f]);
  }
  for (const bool folds : {false, true}) resolver.join_open_edges(folds);
  for (std::size_t v = 0; v < n_vertices; ++v) {
    if (is_doubtful_group[group[v]]) group[v] = resolver.lowest_joined(static_cast<Index>(v));
  }
}

// Some faces were dropped because two corners are at one position, but these corners stayed apart. Such a face closes
// the surface there. It comes back unless it would be the third face of an edge.
void bring_back(const IndexedMesh& mesh, const std::vector<Index>& group, unsigned threads,
                std::vector<char>& is_dropped) {
  const std::vector<Triangle> welded = renumber(mesh.faces, group, threads);
  Flags is_back(welded.size());
  for (std::size_t f = 0; f < welded.size(); ++f) {
    is_back[f] = is_dropped[f] == dropped_as_degenerate && has_three_corners(welded[f]);
  }
  if (!has_any(is_back)) return;
  for (std::size_t f = 0; f < welded.size(); ++f) {
    if (is_back[f]) is_dropped[f] = 0;
  }
  Flags is_present(welded.size());
  for (std::size_t f = 0; f < welded.size(); ++f) is_present[f] = !is_dropped[f] && has_three_corners(welded[f]);
  const GroupedEdges edges(mesh, welded, is_present);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (!edges.is_doubtful(e)) continue;
    for (const Index side : edges.sides(e)) {
      const Index face = whittle::detail::face_of(side);
      if (is_back[face]) is_dropped[face] = dropped_as_degenerate;
    }
  }
}

// Whether welding may lay two copies of a face together: they run along a common edge in the same direction, to third
// corners at one position.
bool may_join_copies(const IndexedMesh& mesh, const std::vector<Triangle>& grouped, const GroupedEdges& edges) {
  constexpr std::size_t most_compared = 16;
  const auto third = [&](Index side) -> const Vec3& {
    return mesh.positions[whittle::detail::start_of(whittle::detail::previous_in_face(side), grouped)];
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> sides = edges.sides(e);
    if (sides.size() > most_compared) return true;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const bool same_way =
            whittle::detail::start_of(sides[i], grouped) == whittle::detail::start_of(sides[j], grouped);
        if (same_way && third(sides[i]) == third(sides[j])) return true;
      }
    }
  }
  return false;
}

// Drops each face with the same corner positions as an earlier face, in the same cyclic order; vertices may differ.
std::size_t drop_faces_at_equal_positions(IndexedMesh& mesh, unsigned threads) {
  const std::vector<Index> group = group_by_position(mesh.positions, Flags(mesh.positions.size(), 1));
  const std::vector<char> is_copy =
      find_duplicate_faces(renumber(mesh.faces, group, threads), mesh.positions.size(), threads);
  return drop_faces(mesh, [&](std::size_t f) { return is_copy[f] != 0; });
}

template <class Numbers>
bool have_same_bits(const Numbers& a, const Numbers& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

bool have_same_attributes(const IndexedMesh& mesh, Index a, Index b) {
  if (!mesh.normals.empty() && !have_same_bits(mesh.normals[a], mesh.normals[b])) return false;
  if (!mesh.colors.empty() && !have_same_bits(mesh.colors[a], mesh.colors[b])) return false;
  return std::all_of(mesh.attributes.begin(), mesh.attributes.end(), [&](const Attribute& attribute) {
    return have_same_bits(attribute.value(a), attribute.value(b));
  });
}

// Makes a wedge of each vertex, if some that are joined have different attributes.
// \param group the vertex that each is joined to
void keep_attributes(IndexedMesh& mesh, const std::vector<Index>& group) {
  const bool has_any = !mesh.normals.empty() || !mesh.colors.empty() || !mesh.attributes.empty();
  if (!mesh.wedges.empty() || !has_any) return;
  for (Index v = 0; v < group.size(); ++v) {
    if (group[v] != v && !have_same_attributes(mesh, v, group[v])) return make_wedge_table(mesh);
  }
}

std::size_t count_welded(const std::vector<Index>& group) {
  std::size_t welded = 0;
  for (std::size_t v = 0; v < group.size(); ++v) welded += group[v] != v;
  return welded;
}

// Flags the faces that welding may change: faces with a corner that isn't alone at its position.
Flags find_touched_faces(const std::vector<Triangle>& faces, const std::vector<Index>& group, unsigned threads) {
  Flags is_shared(group.size());
  for (std::size_t v = 0; v < group.size(); ++v) {
    if (group[v] != v) is_shared[v] = is_shared[group[v]] = 1;
  }
  Flags is_touched(faces.size());
  for_each_range(faces.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const auto& [a, b, c] = faces[f];
      is_touched[f] = static_cast<std::uint8_t>(is_shared[a] | is_shared[b] | is_shared[c]);
    }
  });
  return is_touched;
}

Repairs weld(IndexedMesh& mesh, std::vector<Index>* joined_to, bool drops_copies, unsigned threads) {
  Repairs done;
  if (joined_to != nullptr) joined_to->clear();
  std::vector<Index> group = group_by_position(mesh.positions, find_candidates(mesh, threads));
  done.welded_vertices = count_welded(group);
  if (done.welded_vertices == 0) return done;

  std::vector<Triangle> grouped = renumber(mesh.faces, group, threads);
  const Flags is_touched = find_touched_faces(mesh.faces, group, threads);
  const std::size_t n_vertices = mesh.positions.size();
  const GroupedEdges edges(mesh, grouped, is_touched);
  if (drops_copies && may_join_copies(mesh, grouped, edges)) {
    const std::size_t n_copies = drop_faces_at_equal_positions(mesh, threads);
    done = weld(mesh, joined_to, false, threads);
    done.duplicate_faces += n_copies;
    return done;
  }
  if (!has_any(find_doubtful_groups(edges, n_vertices))) {
    keep_attributes(mesh, group);
    mesh.faces = std::move(grouped);
    if (joined_to != nullptr) *joined_to = std::move(group);
    return done;
  }

  // A duplicate of a face would make all edges of the face doubtful.
  std::vector<char> is_dropped = find_duplicate_faces(grouped, n_vertices, threads);
  for (std::size_t f = 0; f < grouped.size(); ++f) {
    if (!has_three_corners(grouped[f])) is_dropped[f] = dropped_as_degenerate;
  }
  Flags is_kept(grouped.size());
  for (std::size_t f = 0; f < grouped.size(); ++f) is_kept[f] = is_touched[f] && !is_dropped[f];
  resolve_doubtful(mesh, grouped, is_kept, group);
  bring_back(mesh, group, threads, is_dropped);

  done.welded_vertices = count_welded(group);
  done.degenerate_faces =
      static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), dropped_as_degenerate));
  done.duplicate_faces =
      static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), dropped_as_duplicate));
  keep_attributes(mesh, group);
  mesh.faces = renumber(mesh.faces, group, threads);
  drop_faces(mesh, [&](std::size_t f) { return is_dropped[f] != 0; });
  if (joined_to != nullptr && done.welded_vertices > 0) *joined_to = std::move(group);
  return done;
}

}  // namespace

Repairs weld_borders(IndexedMesh& mesh, std::vector<Index>* joined_to, unsigned threads) {
  const Repairs done = weld(mesh, joined_to, false, threads);
  join_equal_wedges(mesh);
  return done;
}

Repairs weld_borders_without_copies(IndexedMesh& mesh, std::vector<Index>* joined_to, unsigned threads) {
  return weld(mesh, joined_to, true, threads);
}

}  // namespace whittle::io
