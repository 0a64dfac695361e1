#include "blocks/shared_stars.hh"

#include "loop/contractor.hh"

namespace whittle {

SharedStars::SharedStars(const WorkingSurface& surface, const Partition& partition) {
  std::vector<std::uint8_t> is_here(surface.positions.size());
  for (const Triangle& face : surface.faces) {
    const auto& [a, b, c] = face;
    const auto& is_shared = partition.is_shared;
    if ((is_shared[a] | is_shared[b] | is_shared[c]) == 0) continue;
    faces_.push_back(face);
    for (const Index v : face) is_here[v] = 1;
  }
  std::vector<Index> numbers(is_here.size());
  for (Index v = 0; v < is_here.size(); ++v) {
    if (is_here[v] == 0) continue;
    numbers[v] = static_cast<Index>(vertices_.size());
    vertices_.push_back(v);
    positions_.push_back(surface.frame.to_frame(surface.positions[v]));
    frozen_.push_back(partition.is_shared[v] == 0);
  }
  for (Triangle& face : faces_) face = mapped(face, numbers);
}

NonmanifoldCounts SharedStars::count_nonmanifold() const {
  TriangleComplex complex(positions_, faces_, Frame{}, 1);
  complex.freeze(frozen_);
  complex.connect({}, 1);
  return complex.count_nonmanifold(false);
}

std::vector<VertexQuadric> SharedStars::quadrics(const DecimateOptions& options) const {
  WorkingSurface stars{.positions = positions_, .faces = faces_};
  StageContext context{options};
  context.frozen = frozen_;
  const Contractor contractor(stars, context);
  const TriangleComplex& complex = contractor.complex();
  const std::vector<Index> vertex_of = complex.vertices_by_origin();
  std::vector<VertexQuadric> quadrics;
  for (Index v = 0; v < vertices_.size(); ++v) {
    if (frozen_[v] == 0) quadrics.push_back({vertices_[v], contractor.cost().quadric(vertex_of[v])});
  }
  return quadrics;
}

}  // namespace whittle
