#include "whittle/core/wedges.hh"

#include <algorithm>
#include <compare>
#include <numeric>
#include <span>

#include "whittle/core/detail/edge_table.hh"
#include "whittle/core/regions.hh"

namespace whittle {
namespace {

/// Number by number.
template <class Values>
std::strong_ordering compared(const Values& a, const Values& b) {
  for (std::size_t i = 0; i < std::size(a); ++i) {
    const auto order = std::strong_order(a[i], b[i]);
    if (order != 0) return order;
  }
  return std::strong_ordering::equal;
}

/// All attributes of two wedges.
std::strong_ordering compared(const IndexedMesh& mesh, Index a, Index b) {
  std::strong_ordering order = std::strong_ordering::equal;
  if (!mesh.normals.empty()) order = compared(mesh.normals[a], mesh.normals[b]);
  if (order == 0 && !mesh.colors.empty()) order = compared(mesh.colors[a], mesh.colors[b]);
  for (std::size_t i = 0; order == 0 && i < mesh.attributes.size(); ++i) {
    order = compared(mesh.attributes[i].value(a), mesh.attributes[i].value(b));
  }
  return order;
}

/// Whether two wedges differ in an attribute that makes a seam.
bool are_apart(const IndexedMesh& mesh, Index a, Index b) {
  if (a == b) return false;
  if (!mesh.colors.empty() && mesh.colors[a] != mesh.colors[b]) return true;
  return std::any_of(mesh.attributes.begin(), mesh.attributes.end(), [&](const Attribute& attribute) {
    const auto of_a = attribute.value(a);
    const auto of_b = attribute.value(b);
    switch (attribute.kind) {
      case AttributeKind::normal:
      case AttributeKind::direction:
        return false;
      case AttributeKind::tangent:
        return of_a.size() == 4 && (of_a[3] < 0) != (of_b[3] < 0);
      default:
        return !std::equal(of_a.begin(), of_a.end(), of_b.begin());
    }
  });
}

}  // namespace

std::size_t n_wedges(const IndexedMesh& mesh) {
  if (mesh.wedges.empty()) return mesh.positions.size();
  if (!mesh.normals.empty()) return mesh.normals.size();
  if (!mesh.colors.empty()) return mesh.colors.size();
  if (!mesh.attributes.empty()) return mesh.attributes.front().size();
  return std::size_t{*std::max_element(mesh.wedges.begin(), mesh.wedges.end())} + 1;
}

std::vector<Index> vertices_of_wedges(const IndexedMesh& mesh) {
  std::vector<Index> vertices(mesh.wedges.empty() ? 0 : n_wedges(mesh), invalid_index);
  for (std::size_t corner = 0; corner < mesh.wedges.size(); ++corner) {
    vertices[mesh.wedges[corner]] = mesh.faces[corner / 3][corner % 3];
  }
  return vertices;
}

detail::IndexLists<Index> wedges_of_vertices(const IndexedMesh& mesh) {
  const std::vector<Index> vertices = vertices_of_wedges(mesh);
  return {mesh.positions.size(), [&](const auto& emit) {
            for (Index w = 0; w < vertices.size(); ++w) {
              if (vertices[w] != invalid_index) emit(vertices[w], w);
            }
          }};
}

void make_wedge_table(IndexedMesh& mesh) {
  if (!mesh.wedges.empty()) return;
  mesh.wedges.reserve(3 * mesh.faces.size());
  for (const Triangle& face : mesh.faces) mesh.wedges.insert(mesh.wedges.end(), face.begin(), face.end());
}

void gather_wedges(IndexedMesh& mesh, std::span<const Index> kept) {
  const auto gather = [&](auto& values) {
    if (values.empty()) return;
    std::remove_reference_t<decltype(values)> gathered;
    gathered.reserve(kept.size());
    for (const Index w : kept) gathered.push_back(values[w]);
    values = std::move(gathered);
  };
  gather(mesh.normals);
  gather(mesh.colors);
  for (Attribute& attribute : mesh.attributes) {
    std::vector<double> gathered;
    gathered.reserve(kept.size() * attribute.n_components);
    for (const Index w : kept) {
      const std::span<const double> value = attribute.value(w);
      gathered.insert(gathered.end(), value.begin(), value.end());
    }
    attribute.values = std::move(gathered);
  }
}

void join_equal_wedges(IndexedMesh& mesh) {
  if (mesh.wedges.empty()) return;
  const std::vector<Index> vertices = vertices_of_wedges(mesh);
  std::vector<Index> order;
  for (Index w = 0; w < vertices.size(); ++w) {
    if (vertices[w] != invalid_index) order.push_back(w);
  }
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return vertices[a] < vertices[b]; });
  std::vector<Index> first_equal(vertices.size());
  std::iota(first_equal.begin(), first_equal.end(), Index{0});
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end = std::find_if(begin, order.end(), [&](Index w) { return vertices[w] != vertices[*begin]; });
    if (end - begin > 1) {
      std::vector<Index> at_vertex(begin, end);
      std::stable_sort(at_vertex.begin(), at_vertex.end(), [&](Index a, Index b) { return compared(mesh, a, b) < 0; });
      for (std::size_t i = 1; i < at_vertex.size(); ++i) {
        if (compared(mesh, at_vertex[i - 1], at_vertex[i]) == 0)
          first_equal[at_vertex[i]] = first_equal[at_vertex[i - 1]];
      }
    }
    begin = end;
  }
  std::erase_if(order, [&](Index w) { return first_equal[w] != w; });
  std::vector<Index> numbers(vertices.size(), invalid_index);
  for (Index i = 0; i < order.size(); ++i) numbers[order[i]] = i;
  bool is_plain = order.size() == mesh.positions.size();
  for (Index i = 0; i < order.size() && is_plain; ++i) is_plain = vertices[order[i]] == i;
  for (Index& w : mesh.wedges) w = numbers[first_equal[w]];
  gather_wedges(mesh, order);
  if (is_plain) mesh.wedges.clear();
}

void drop_seams(IndexedMesh& mesh) {
  if (mesh.wedges.empty()) return;
  std::vector<Index> lowest(mesh.positions.size(), invalid_index);
  for (std::size_t corner = 0; corner < mesh.wedges.size(); ++corner) {
    Index& w = lowest[mesh.faces[corner / 3][corner % 3]];
    w = std::min(w, mesh.wedges[corner]);
  }
  for (Index& w : lowest) {
    if (w == invalid_index) w = 0;  // of a vertex without a face
  }
  gather_wedges(mesh, lowest);
  mesh.wedges.clear();
}

IndexedMesh split_at_wedges(const IndexedMesh& mesh) {
  IndexedMesh split = mesh;
  if (mesh.wedges.empty()) return split;
  join_equal_wedges(split);  // so that each wedge has a corner
  if (split.wedges.empty()) return split;
  const std::vector<Index> vertices = vertices_of_wedges(split);
  split.positions.clear();
  split.origins.clear();
  for (const Index v : vertices) {
    split.positions.push_back(mesh.positions[v]);
    split.origins.push_back(mesh.origins.empty() ? v : mesh.origins[v]);
  }
  for (std::size_t corner = 0; corner < split.wedges.size(); ++corner) {
    split.faces[corner / 3][corner % 3] = split.wedges[corner];
  }
  split.wedges.clear();
  return split;
}

IndexedMesh without_attributes(const IndexedMesh& mesh) {
  IndexedMesh surface;
  surface.positions = mesh.positions;
  surface.faces = mesh.faces;
  return surface;
}

namespace {

/// The faces with a corner where its vertex differs between faces; a seam has no others.
std::vector<std::uint8_t> faces_at_seams(const IndexedMesh& mesh, std::span<const Index> regions) {
  const auto region = [&](std::size_t f) { return regions.empty() ? 0 : regions[f]; };
  std::vector<Index> first(mesh.positions.size(), invalid_index);  // corner at each vertex
  std::vector<std::uint8_t> has_several(mesh.positions.size(), 0);
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    for (Index k = 0; k < 3; ++k) {
      const Index v = mesh.faces[f][k];
      if (first[v] == invalid_index) first[v] = 3 * f + k;
      if (has_several[v] != 0) continue;
      const bool differs = region(f) != region(first[v] / 3) ||
                           are_apart(mesh, mesh.wedge(f, k), mesh.wedge(first[v] / 3, first[v] % 3));
      has_several[v] = static_cast<std::uint8_t>(differs);
    }
  }
  std::vector<std::uint8_t> is_there(mesh.faces.size());
  for (std::size_t f = 0; f < is_there.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    is_there[f] = static_cast<std::uint8_t>(has_several[a] | has_several[b] | has_several[c]);
  }
  return is_there;
}

}  // namespace

std::vector<VertexPair> seam_edges(const IndexedMesh& mesh, std::span<const Index> regions) {
  std::vector<VertexPair> seams;
  if (mesh.wedges.empty() && regions.empty()) return seams;
  const detail::EdgeTable edges(mesh.faces, mesh.positions.size(), faces_at_seams(mesh, regions));
  const auto wedge_at = [&](Index side, Index vertex) {
    const Index f = detail::face_of(side);
    const Triangle& face = mesh.faces[f];
    return mesh.wedge(f, static_cast<std::size_t>(std::find(face.begin(), face.end(), vertex) - face.begin()));
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const std::span<const Index> sides = edges.sides(e);
    if (sides.size() != 2) continue;
    const auto& [a, b] = edges[e];
    const bool is_between_regions =
        !regions.empty() && regions[detail::face_of(sides[0])] != regions[detail::face_of(sides[1])];
    const auto is_apart_at = [&](Index v) { return are_apart(mesh, wedge_at(sides[0], v), wedge_at(sides[1], v)); };
    if (is_between_regions || is_apart_at(a) || is_apart_at(b)) seams.push_back(edges[e]);
  }
  return seams;
}

std::vector<VertexPair> seam_edges(const IndexedMesh& mesh) { return seam_edges(mesh, face_regions(mesh)); }

std::vector<Index> join_vertices(IndexedMesh& mesh, std::span<const Index> joined) {
  make_wedge_table(mesh);
  std::vector<Index> map(joined.size());
  Index n = 0;
  for (Index v = 0; v < joined.size(); ++v) {
    map[v] = joined[v] == v ? n : map[joined[v]];
    if (joined[v] != v) continue;
    mesh.positions[n] = mesh.positions[v];
    mesh.origins[n++] = mesh.origins[v];
  }
  mesh.positions.resize(n);
  mesh.origins.resize(n);
  for (Triangle& face : mesh.faces) face = {map[face[0]], map[face[1]], map[face[2]]};
  join_equal_wedges(mesh);
  return map;
}

}  // namespace whittle
