#include <algorithm>
#include <utility>

#include "encoding.hh"
#include "whittle/core/wedges.hh"
#include "whittle/report/page.hh"

namespace whittle::report {
namespace {

Triangle from_lowest(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Vertices in the order in which faces name them, then vertices without a face.
std::vector<Index> vertex_numbers(const std::vector<Triangle>& faces, std::size_t n_vertices) {
  std::vector<Index> numbers(n_vertices, invalid_index);
  Index next = 0;
  const auto number = [&next](Index& of_one) {
    if (of_one == invalid_index) of_one = next++;
  };
  for (const Triangle& face : faces) {
    for (const Index v : face) number(numbers[v]);
  }
  for (Index& of_one : numbers) number(of_one);
  return numbers;
}

/// Faces with the same corners may swap their numbers.
std::vector<Index> face_numbers(const std::vector<Triangle>& before, const std::vector<Triangle>& after) {
  using Numbered = std::vector<std::pair<Triangle, Index>>;
  const auto sorted = [](const std::vector<Triangle>& faces) {
    Numbered all;
    for (Index f = 0; f < faces.size(); ++f) all.emplace_back(from_lowest(faces[f]), f);
    std::sort(all.begin(), all.end());
    return all;
  };
  const Numbered old = sorted(before);
  const Numbered now = sorted(after);
  std::vector<Index> numbers(before.size());
  for (std::size_t i = 0; i < old.size(); ++i) numbers[old[i].second] = now[i].second;
  return numbers;
}

bool has_attributes(const IndexedMesh& mesh) {
  return !mesh.normals.empty() || !mesh.colors.empty() || !mesh.attributes.empty();
}

/// Number of corners by which a face was rotated. \param before with the vertex numbers of `after`
std::size_t rotation(Triangle before, const Triangle& after) {
  std::size_t n = 0;
  for (; before != after; ++n) std::rotate(before.begin(), before.begin() + 1, before.end());
  return n;
}

/// The wedges of `before`, by the faces of `after`.
std::vector<Index> wedges_in_order(const IndexedMesh& before, const PageOrder& order, const IndexedMesh& after) {
  std::vector<Index> wedges(3 * after.faces.size());
  for (std::size_t f = 0; f < before.faces.size(); ++f) {
    const std::size_t to = order.of_face[f];
    Triangle face = before.faces[f];
    for (Index& v : face) v = order.of_vertex[v];
    const std::size_t n = rotation(face, after.faces[to]);
    for (std::size_t k = 0; k < 3; ++k) wedges[3 * to + k] = before.wedge(f, (k + n) % 3);
  }
  return wedges;
}

/// Gives the ordered mesh the attributes of wedges. The first wedge of each vertex gets the vertex's number.
void order_wedges(const IndexedMesh& before, const PageOrder& order, IndexedMesh& mesh) {
  std::vector<Index> wedges = wedges_in_order(before, order, mesh);
  std::vector<Index> kept(mesh.positions.size(), invalid_index);
  std::vector<Index> numbers(n_wedges(before), invalid_index);
  for (std::size_t corner = 0; corner < wedges.size(); ++corner) {
    const Index vertex = mesh.faces[corner / 3][corner % 3];
    Index& number = numbers[wedges[corner]];
    if (number == invalid_index) {
      const bool is_first = kept[vertex] == invalid_index;
      number = is_first ? vertex : static_cast<Index>(kept.size());
      if (is_first) kept[vertex] = wedges[corner];
      if (!is_first) kept.push_back(wedges[corner]);
    }
    wedges[corner] = number;
  }
  std::replace(kept.begin(), kept.end(), invalid_index, Index{0});  // no face shows them
  mesh.normals = before.normals;
  mesh.colors = before.colors;
  mesh.attributes = before.attributes;
  gather_wedges(mesh, kept);
  if (kept.size() > mesh.positions.size()) mesh.wedges = std::move(wedges);
}

}  // namespace

PageOrder put_in_page_order(IndexedMesh& mesh) {
  std::vector<Triangle> faces = in_short_order(mesh.faces, mesh.positions.size());
  PageOrder order{vertex_numbers(faces, mesh.positions.size()), face_numbers(mesh.faces, faces)};
  IndexedMesh ordered;
  ordered.positions.resize(mesh.positions.size());
  for (Index v = 0; v < mesh.positions.size(); ++v) ordered.positions[order.of_vertex[v]] = mesh.positions[v];
  for (Triangle& face : faces) {
    for (Index& v : face) v = order.of_vertex[v];
    ordered.faces.push_back(from_lowest(face));
  }
  if (has_attributes(mesh)) order_wedges(mesh, order, ordered);
  if (!mesh.face_groups.empty()) {
    ordered.face_groups.resize(mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) ordered.face_groups[order.of_face[f]] = mesh.face_groups[f];
    ordered.group_names = std::move(mesh.group_names);
  }
  mesh = std::move(ordered);
  return order;
}

}  // namespace whittle::report
