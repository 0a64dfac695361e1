#include <meshoptimizer.h>

#include <algorithm>
#include <utility>

#include "whittle/report/page.hh"

namespace whittle::report {
namespace {

Triangle from_lowest(Triangle face) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  return face;
}

/// Faces in the order that meshoptimizer gives them, which says nothing of their numbers before.
std::vector<Triangle> reordered(const IndexedMesh& mesh) {
  std::vector<Triangle> faces(mesh.faces.size());
  if (faces.empty()) return faces;
  meshopt_optimizeVertexCache(faces.data()->data(), mesh.faces.data()->data(), 3 * faces.size(), mesh.positions.size());
  return faces;
}

/// In the order in which faces name them; then those without a face.
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

/// Of faces with the same corners any may have any of their numbers.
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

}  // namespace

PageOrder put_in_page_order(IndexedMesh& mesh) {
  std::vector<Triangle> faces = reordered(mesh);
  PageOrder order{vertex_numbers(faces, mesh.positions.size()), face_numbers(mesh.faces, faces)};
  IndexedMesh ordered;
  ordered.positions.resize(mesh.positions.size());
  for (Index v = 0; v < mesh.positions.size(); ++v) ordered.positions[order.of_vertex[v]] = mesh.positions[v];
  for (Triangle& face : faces) {
    for (Index& v : face) v = order.of_vertex[v];
    ordered.faces.push_back(from_lowest(face));
  }
  mesh = std::move(ordered);
  return order;
}

}  // namespace whittle::report
