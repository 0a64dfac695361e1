#include "sampling/surface_sampler.hh"

#include <Eigen/Geometry>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "whittle/core/geometry/segment.hh"
#include "whittle/core/geometry/triangle.hh"

namespace whittle::metrics {

void check_samples(std::size_t n_samples) {
  constexpr std::uint64_t max_samples = std::uint64_t{1} << 40;
  if (n_samples >= 1 && n_samples <= max_samples) return;
  throw std::invalid_argument("number of samples is to be in 1 ... 2^40, not " + std::to_string(n_samples));
}

SurfaceSampler::SurfaceSampler(const IndexedMesh& mesh, const Vec3& origin, std::size_t n_samples, CounterRandom random)
    : mesh_(mesh), origin_(origin), n_samples_(n_samples), random_(random), area_before_(mesh.faces.size() + 1, 0.0) {
  for (const bool by_area : {true, false}) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      area_before_[f + 1] = area_before_[f] + (by_area ? area_of(corners(f)) : 1.0);
    }
    if (area_before_.back() > 0.0) break;
  }
}

Vec3 SurfaceSampler::in_tree(std::size_t face, const Vec3& point) const {
  Triangle ascending = mesh_.faces[face];  // as trees have it
  std::sort(ascending.begin(), ascending.end());
  const Vec3 a = at(ascending[0]), b = at(ascending[1]), c = at(ascending[2]);
  if (!trusted_normal(a, b, c).isZero(0.0)) return point;
  Vec3 from = a, to = b;
  for (const auto& [p, q] : {std::pair(b, c), std::pair(c, a)}) {
    if ((q - p).squaredNorm() > (to - from).squaredNorm()) from = p, to = q;
  }
  return from + nearest_share(point, from, to) * (to - from);
}

}  // namespace whittle::metrics
