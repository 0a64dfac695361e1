// Welding in two steps. First every position on open borders is taken for one vertex; edges then have faces by
// position. Where no edge gets a third face by that, it is the answer. The other edges are *doubtful*, and so are the
// positions at their ends; there the vertices start apart, and `Resolver` joins them.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>

#include "buckets.hh"
#include "repair_detail.hh"
#include "weld_resolver.hh"
#include "whittle/io/repair.hh"

namespace whittle::io {

namespace {

struct EdgeEnd {
  Index higher;
  Index face;
  auto operator<=>(const EdgeEnd&) const = default;
};

// Calls visit(lower, higher, faces) for every edge, in ascending order, the faces ascending.
template <class Visit>
void for_each_edge(const std::vector<Triangle>& faces, std::size_t vertices, const std::vector<char>& is_dropped,
                   const Visit& visit) {
  Buckets<EdgeEnd> by_lower(vertices, [&](const auto& emit) {
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const Triangle& t = faces[f];
      if (is_degenerate(t) || (!is_dropped.empty() && is_dropped[f] != 0)) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [lower, higher] = std::minmax(t[c], t[(c + 1) % 3]);
        emit(lower, EdgeEnd{higher, static_cast<Index>(f)});
      }
    }
  });
  for (std::size_t v = 0; v < vertices; ++v) {
    const std::span<EdgeEnd> ends = by_lower[v];
    std::sort(ends.begin(), ends.end());
    for (std::size_t first = 0; first < ends.size();) {
      std::size_t last = first + 1;
      while (last < ends.size() && ends[last].higher == ends[first].higher) ++last;
      visit(static_cast<Index>(v), ends[first].higher, std::span<const EdgeEnd>(ends.subspan(first, last - first)));
      first = last;
    }
  }
}

std::vector<char> find_border_vertices(const IndexedMesh& mesh) {
  std::vector<char> is_border(mesh.positions.size(), 0);
  for_each_edge(mesh.faces, mesh.positions.size(), {}, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    if (faces.size() == 1) is_border[a] = is_border[b] = 1;
  });
  return is_border;
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

// For each vertex the lowest border vertex at its position; for vertices not on a border, the vertex itself.
std::vector<Index> group_by_position(const std::vector<Vec3>& positions, const std::vector<char>& is_border) {
  std::vector<Index> group(positions.size());
  std::iota(group.begin(), group.end(), Index{0});
  const auto members = static_cast<std::size_t>(std::count(is_border.begin(), is_border.end(), 1));
  const std::size_t slots = std::bit_ceil(2 * members + 1);
  std::vector<Index> table(slots, invalid_index);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    if (!is_border[v]) continue;
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

// The vertices of the mesh that are the ends of an edge by position in one of its faces.
std::array<Index, 2> stored_edge(const Triangle& stored, const Triangle& grouped, Index a, Index b) {
  std::array<Index, 2> ends{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (grouped[c] == a) ends[0] = stored[c];
    if (grouped[c] == b) ends[1] = stored[c];
  }
  return ends;
}

// More than two faces, and not all of them at one edge of the mesh as it is: welding would be to blame.
bool is_doubtful(const IndexedMesh& mesh, const std::vector<Triangle>& grouped, Index a, Index b,
                 std::span<const EdgeEnd> faces) {
  if (faces.size() <= 2) return false;
  const auto first = stored_edge(mesh.faces[faces[0].face], grouped[faces[0].face], a, b);
  return std::any_of(faces.begin() + 1, faces.end(), [&](const EdgeEnd& end) {
    return stored_edge(mesh.faces[end.face], grouped[end.face], a, b) != first;
  });
}

bool has_doubtful_edge(const IndexedMesh& mesh, const std::vector<Triangle>& grouped) {
  bool found = false;
  for_each_edge(grouped, mesh.positions.size(), {}, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    found = found || is_doubtful(mesh, grouped, a, b, faces);
  });
  return found;
}

// Joins what can be joined; `group` becomes the lowest vertex of each joined set.
void resolve_doubtful(const IndexedMesh& mesh, const std::vector<Triangle>& grouped,
                      const std::vector<char>& is_dropped, std::vector<Index>& group) {
  const std::size_t vertices = mesh.positions.size();
  std::vector<char> is_doubtful_group(vertices, 0);
  WeldResolver resolver;
  for_each_edge(grouped, vertices, is_dropped, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    if (!is_doubtful(mesh, grouped, a, b, faces)) return;
    is_doubtful_group[a] = is_doubtful_group[b] = 1;
  });
  for (std::size_t v = 0; v < vertices; ++v) {
    if (is_doubtful_group[group[v]]) resolver.add_vertex(static_cast<Index>(v));
  }
  for_each_edge(grouped, vertices, is_dropped, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    if (!is_doubtful(mesh, grouped, a, b, faces)) return;
    resolver.begin_edge();
    for (const EdgeEnd& end : faces) {
      const Triangle& face = grouped[end.face];
      const auto [at_a, at_b] = stored_edge(mesh.faces[end.face], face, a, b);
      const auto corner = static_cast<std::size_t>(std::find(face.begin(), face.end(), a) - face.begin());
      resolver.add_face({at_a, at_b}, face[(corner + 1) % 3] == b);
    }
  });
  for_each_edge(grouped, vertices, is_dropped, [&](Index a, Index b, std::span<const EdgeEnd> faces) {
    if (faces.size() != 2) return;
    const auto first = stored_edge(mesh.faces[faces[0].face], grouped[faces[0].face], a, b);
    const auto second = stored_edge(mesh.faces[faces[1].face], grouped[faces[1].face], a, b);
    if (is_doubtful_group[a]) resolver.join(first[0], second[0]);
    if (is_doubtful_group[b]) resolver.join(first[1], second[1]);
  });
  resolver.join_open_edges();
  for (std::size_t v = 0; v < vertices; ++v) {
    if (is_doubtful_group[group[v]]) group[v] = resolver.lowest_joined(static_cast<Index>(v));
  }
}

}  // namespace

Repairs weld_borders(IndexedMesh& mesh) {
  Repairs done;
  const std::vector<char> is_border = find_border_vertices(mesh);
  if (std::find(is_border.begin(), is_border.end(), 1) == is_border.end()) return done;
  std::vector<Index> group = group_by_position(mesh.positions, is_border);
  const auto count_welded = [&] {
    std::size_t welded = 0;
    for (std::size_t v = 0; v < group.size(); ++v) welded += group[v] != v;
    return welded;
  };
  if (count_welded() == 0) return done;

  const std::vector<Triangle> grouped = renumber(mesh.faces, group);
  if (!has_doubtful_edge(mesh, grouped)) {
    mesh.faces = grouped;
    done.welded_vertices = count_welded();
    return done;
  }
  // A face that lies twice at the same place would make all its edges doubtful.
  std::vector<char> is_dropped = find_duplicate_faces(grouped, mesh.positions.size());
  done.duplicate_faces = static_cast<std::size_t>(std::count(is_dropped.begin(), is_dropped.end(), 1));
  for (std::size_t f = 0; f < grouped.size(); ++f) {
    if (!is_degenerate(grouped[f])) continue;
    is_dropped[f] = 1;
    ++done.degenerate_faces;
  }
  resolve_doubtful(mesh, grouped, is_dropped, group);
  done.welded_vertices = count_welded();
  mesh.faces = renumber(mesh.faces, group);
  drop_faces(mesh, [&](std::size_t f) { return is_dropped[f] != 0; });
  return done;
}

}  // namespace whittle::io
