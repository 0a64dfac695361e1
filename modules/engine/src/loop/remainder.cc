#include "loop/remainder.hh"

#include <algorithm>

#include "whittle/core/detail/large_array.hh"

namespace whittle {
namespace {

/// The vertices of the complex that are left, by their numbers among those that the pass began with.
/// \param went_to vertices that the pass began with → vertices of the complex
std::vector<Index> vertices_left(const TriangleComplex& complex, const std::vector<Index>& went_to) {
  std::vector<Index> vertices;
  reserve_large(vertices, complex.n_vertices());
  for (Index i = 0; i < went_to.size(); ++i) {
    if (went_to[i] != invalid_index && complex.identity(went_to[i]) == i) vertices.push_back(went_to[i]);
  }
  return vertices;
}

/// Those that an edge decides are left out: their vertices share a face.
std::vector<VertexPair> threshold_pairs_left(TriangleComplex& complex, const std::vector<Index>& numbers) {
  std::vector<VertexPair> pairs;
  for (auto id = static_cast<Index>(complex.n_edges()); id < complex.n_pair_slots(); ++id) {
    if (!complex.is_pair_alive(id)) continue;
    const auto [a, b] = complex.ends(id);
    if (!complex.is_contractible({id, a, b}) || complex.have_common_face(a, b)) continue;
    const auto [low, high] = std::minmax(numbers[a], numbers[b]);
    pairs.push_back({low, high});
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

Remainder Remainder::geometry() const {
  Remainder copy;
  copy.positions = positions;
  copy.faces = faces;
  copy.origins = origins;
  copy.face_origins = face_origins;
  copy.vertex_map = vertex_map;
  copy.lines = lines;
  copy.quadrics = quadrics;
  return copy;
}

Remainder remainder_of(Pass& pass, std::span<const Triangle> faces, const Remainder* before,
                       const Gathering& gathering) {
  TriangleComplex& complex = pass.complex();
  std::vector<Index> went_to = representatives(complex);
  const std::vector<Index> vertices = vertices_left(complex, went_to);
  std::vector<Index> numbers(complex.n_vertex_slots(), invalid_index);
  Remainder left;
  reserve_large(left.positions, vertices.size());
  reserve_large(left.origins, vertices.size());
  for (const Index v : vertices) {
    numbers[v] = static_cast<Index>(left.positions.size());
    left.positions.push_back(complex.position(v));
    left.origins.push_back(before ? before->origins[complex.identity(v)] : complex.identity(v));
  }
  left.face_origins = surviving_faces(faces, went_to, complex);
  for (Index& v : went_to) {
    if (v != invalid_index) v = numbers[v];
  }
  reserve_large(left.faces, left.face_origins.size());
  for (Index& f : left.face_origins) {
    left.faces.push_back(mapped(faces[f], went_to));
    if (before) f = before->face_origins[f];
  }
  if (before) {
    reserve_large(left.vertex_map, before->vertex_map.size());
    for (const Index v : before->vertex_map) left.vertex_map.push_back(v == invalid_index ? v : went_to[v]);
  } else {
    left.vertex_map = std::move(went_to);
  }
  left.lines = pass.feature_lines(numbers);
  if (gathering.quadrics) {
    reserve_large(left.quadrics, vertices.size());
    for (const Index v : vertices) left.quadrics.push_back({complex.position(v), pass.cost().quadric(v)});
  }
  if (!gathering.what_to_go_on_from) return left;
  left.cost_state = pass.cost().state(vertices);
  left.threshold_pairs = threshold_pairs_left(complex, numbers);
  return left;
}

}  // namespace whittle
