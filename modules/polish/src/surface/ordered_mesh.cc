#include "surface/ordered_mesh.hh"

#include <algorithm>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/space_filling_curve.hh"

namespace whittle::polishing {

OrderedMesh::OrderedMesh(const IndexedMesh& from, const Frame& frame, unsigned threads)
    : vertices_(morton_order(from.positions, frame, threads)), numbers_(vertices_.size()) {
  for (Index v = 0; v < vertices_.size(); ++v) numbers_[vertices_[v]] = v;
  mesh.positions.reserve(vertices_.size());
  for (const Index v : vertices_) mesh.positions.push_back(from.positions[v]);
  const detail::IndexLists<Index> by_lowest(vertices_.size(), [&](const auto& add) {
    for (Index f = 0; f < from.faces.size(); ++f) {
      const auto& [a, b, c] = from.faces[f];
      add(std::min({numbers_[a], numbers_[b], numbers_[c]}), f);
    }
  });
  faces_.reserve(from.faces.size());
  mesh.faces.reserve(from.faces.size());
  for (Index v = 0; v < vertices_.size(); ++v) {
    for (const Index f : by_lowest.of(v)) {
      const auto& [a, b, c] = from.faces[f];
      faces_.push_back(f);
      mesh.faces.push_back({numbers_[a], numbers_[b], numbers_[c]});
    }
  }
}

std::vector<Index> OrderedMesh::map(std::span<const Index> vertices) const {
  std::vector<Index> result;
  result.reserve(vertices.size());
  for (const Index v : vertices) result.push_back(v == invalid_index ? v : numbers_[v]);
  return result;
}

std::vector<VertexPair> OrderedMesh::map(std::span<const VertexPair> edges) const {
  std::vector<VertexPair> result;
  for (const auto& [a, b] : edges) result.push_back({numbers_[a], numbers_[b]});
  return result;
}

std::vector<std::uint8_t> OrderedMesh::per_vertex(std::span<const std::uint8_t> values) const {
  std::vector<std::uint8_t> result;
  if (values.empty()) return result;
  for (const Index v : vertices_) result.push_back(values[v]);
  return result;
}

std::vector<Index> OrderedMesh::per_face(std::span<const Index> values) const {
  std::vector<Index> result;
  if (values.empty()) return result;
  for (const Index f : faces_) result.push_back(values[f]);
  return result;
}

void OrderedMesh::write_to(IndexedMesh& to) const {
  for (std::size_t v = 0; v < vertices_.size(); ++v) to.positions[vertices_[v]] = mesh.positions[v];
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    to.faces[faces_[f]] = {vertices_[a], vertices_[b], vertices_[c]};
  }
}

}  // namespace whittle::polishing
