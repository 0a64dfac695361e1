#include "cost/attributes/surface_attributes.hh"

#include <algorithm>
#include <numeric>
#include <utility>

#include "whittle/core/detail/index_lists.hh"
#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/wedges.hh"

namespace whittle {
namespace {

/// The input's wedges that have faces, numbered by their vertices.
struct NumberedWedges {
  std::vector<Index> numbers;    ///< of the input's wedges, or `invalid_index`
  std::vector<Index> of_input;   ///< by number, the input's wedge
  std::vector<Index> vertex_of;  ///< by number; ascending
};

NumberedWedges number_wedges(const IndexedMesh& input) {
  NumberedWedges result;
  if (input.wedges.empty()) {
    result.numbers.resize(input.positions.size());
    std::iota(result.numbers.begin(), result.numbers.end(), Index{0});
    result.of_input = result.vertex_of = result.numbers;
    return result;
  }
  std::vector<Index> vertices(n_wedges(input), invalid_index);
  for (std::size_t f = 0; f < input.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) vertices[input.wedge(f, k)] = input.faces[f][k];
  }
  const detail::IndexLists<Index> wedges_at(input.positions.size(), [&](const auto& emit) {
    for (Index w = 0; w < vertices.size(); ++w) {
      if (vertices[w] != invalid_index) emit(vertices[w], w);
    }
  });
  result.numbers.assign(vertices.size(), invalid_index);
  result.vertex_of.reserve(vertices.size());
  for (Index v = 0; v < wedges_at.size(); ++v) {
    for (const Index w : wedges_at.of(v)) {
      result.numbers[w] = static_cast<Index>(result.vertex_of.size());
      result.of_input.push_back(w);
      result.vertex_of.push_back(v);
    }
  }
  return result;
}

}  // namespace

SurfaceAttributes SurfaceAttributes::at(std::span<const Index> vertices) const {
  std::vector<Index> chosen;
  SurfaceAttributes some;
  auto next = vertex_of.begin();
  for (Index i = 0; i < vertices.size(); ++i) {
    next = std::lower_bound(next, vertex_of.end(), vertices[i]);
    for (; next != vertex_of.end() && *next == vertices[i]; ++next) {
      chosen.push_back(static_cast<Index>(next - vertex_of.begin()));
      some.vertex_of.push_back(i);
    }
  }
  some.wedges = wedges.gathered(chosen);
  some.farthest = farthest;
  return some;
}

SurfaceAttributes sum_attributes(const IndexedMesh& input, const Frame& frame, const ScaledAttributes& attributes,
                                 std::span<const Vec3> positions, unsigned threads) {
  NumberedWedges wedges = number_wedges(input);
  const std::size_t n = wedges.vertex_of.size();
  const detail::IndexLists<Index, std::size_t> faces_of(n, [&](const auto& emit) {
    for (Index f = 0; f < input.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) emit(wedges.numbers[input.wedge(f, k)], f);
    }
  });
  SurfaceAttributes sums{WedgeQuadrics(n, attributes.n_components), std::move(wedges.vertex_of), attributes.farthest};
  const auto row = [&](Index wedge) { return attributes.values.data() + wedge * attributes.stride(); };
  const auto set = [&](Index w, std::vector<WedgeFace>& faces) {
    const Vec3& origin = positions[sums.vertex_of[w]];
    faces.clear();
    for (const Index f : faces_of.of(w)) {
      const FaceGradient gradient(frame.to_frame(corners_of(input.positions, input.faces[f])));
      if (!(gradient.area > 0)) continue;
      const auto corner = [&](std::size_t k) { return row(input.wedge(f, k)); };
      faces.push_back({gradient, origin - gradient.center, {corner(0), corner(1), corner(2)}});
    }
    sums.wedges.set(w, faces, row(wedges.of_input[w]));
  };
  for_each_range(n, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<WedgeFace> faces;
    for (auto w = static_cast<Index>(begin); w < end; ++w) set(w, faces);
  });
  return sums;
}

}  // namespace whittle
