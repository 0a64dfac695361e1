#include "cost/attributes/input_attributes.hh"

#include <numeric>
#include <utility>

#include "whittle/core/detail/parallel.hh"
#include "whittle/core/geometry/triangle.hh"
#include "whittle/core/wedges.hh"

namespace whittle {

InputAttributes::InputAttributes(const IndexedMesh& input, const Frame& frame, ScaledAttributes attributes)
    : input_(input), frame_(frame), attributes_(std::move(attributes)), wedges_at_(wedges_of_vertices(input)) {
  faces_of_ = detail::IndexLists<Index, std::size_t>(n_wedges(input), [&](const auto& emit) {
    for (Index f = 0; f < input.faces.size(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) emit(input.wedge(f, k), f);
    }
  });
}

SurfaceAttributes InputAttributes::at(std::span<const Index> vertices, unsigned threads) const {
  SurfaceAttributes sums;
  std::vector<Index> wedges;
  const auto choose = [&](Index w, Index i) {
    if (faces_of_.of(w).empty()) return;
    wedges.push_back(w);
    sums.vertex_of.push_back(i);
  };
  for (Index i = 0; i < vertices.size(); ++i) {
    if (input_.wedges.empty()) {
      choose(vertices[i], i);
    } else {
      for (const Index w : wedges_at_.of(vertices[i])) choose(w, i);
    }
  }
  sums.farthest = attributes_.farthest;
  sums.wedges = WedgeQuadrics(wedges.size(), attributes_.n_components);
  for_each_range(wedges.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::vector<WedgeFace> faces;
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      sum_up(wedges[i], vertices[sums.vertex_of[i]], i, faces, sums.wedges);
    }
  });
  return sums;
}

SurfaceAttributes InputAttributes::all(unsigned threads) const {
  std::vector<Index> vertices(input_.positions.size());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  return at(vertices, threads);
}

/// \param place of the wedge in `sums` \param faces scratch
void InputAttributes::sum_up(Index wedge, Index vertex, Index place, std::vector<WedgeFace>& faces,
                             WedgeQuadrics& sums) const {
  const Vec3 origin = frame_.to_frame(input_.positions[vertex]);
  faces.clear();
  for (const Index f : faces_of_.of(wedge)) {
    const FaceGradient gradient(frame_.to_frame(corners_of(input_.positions, input_.faces[f])));
    if (!(gradient.area > 0)) continue;
    const auto corner = [&](std::size_t k) { return values(input_.wedge(f, k)); };
    faces.push_back({gradient, origin - gradient.center, {corner(0), corner(1), corner(2)}});
  }
  sums.set(place, faces, values(wedge));
}

}  // namespace whittle
