#include "loop/remainder.hh"

#include <algorithm>

namespace whittle {
namespace {

/// Fills in vertices, and what is remembered about them. \return vertices of the complex → those that are left
/// \param went_to vertices that the pass began with → vertices of the complex
std::vector<Index> write_vertices(const Pass& pass, const std::vector<Index>& went_to, const Remainder* before,
                                  std::vector<PlacedQuadric>* quadrics, Remainder& left) {
  const TriangleComplex& complex = pass.complex();
  std::vector<Index> numbers(complex.n_vertex_slots(), invalid_index);
  left.positions.reserve(complex.n_vertices());
  left.origins.reserve(complex.n_vertices());
  if (quadrics) quadrics->reserve(complex.n_vertices());
  for (Index i = 0; i < went_to.size(); ++i) {
    const Index v = went_to[i];
    if (v == invalid_index || complex.identity(v) != i) continue;
    numbers[v] = static_cast<Index>(left.positions.size());
    left.positions.push_back(complex.position(v));
    left.origins.push_back(before ? before->origins[i] : i);
    if (quadrics) quadrics->push_back(pass.cost().quadric(v));
    if (pass.cost().remembers(v)) left.memory.quadrics.push_back({numbers[v], pass.cost().quadric(v).quadric});
  }
  return numbers;
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

Remainder remainder_of(Pass& pass, std::span<const Triangle> faces, const Remainder* before,
                       std::vector<PlacedQuadric>* quadrics) {
  Remainder left;
  std::vector<Index> went_to = representatives(pass.complex());
  const std::vector<Index> numbers = write_vertices(pass, went_to, before, quadrics, left);
  left.face_origins = surviving_faces(faces, went_to, pass.complex());
  for (Index& v : went_to) {
    if (v != invalid_index) v = numbers[v];
  }
  left.faces.reserve(left.face_origins.size());
  for (Index& f : left.face_origins) {
    left.faces.push_back(mapped(faces[f], went_to));
    if (before) f = before->face_origins[f];
  }
  if (before) {
    left.vertex_map = before->vertex_map;
    for (Index& v : left.vertex_map) {
      if (v != invalid_index) v = went_to[v];
    }
  } else {
    left.vertex_map = std::move(went_to);
  }
  left.memory.face_area = pass.cost().face_area();
  left.lines = pass.feature_lines(numbers);
  left.threshold_pairs = threshold_pairs_left(pass.complex(), numbers);
  return left;
}

}  // namespace whittle
