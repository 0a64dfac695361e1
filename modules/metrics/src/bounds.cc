#include "whittle/metrics/bounds.hh"

#include <limits>
#include <stdexcept>
#include <string>

namespace whittle::metrics {

Bounds bounds(const IndexedMesh& mesh) {
  if (mesh.faces.empty()) throw std::invalid_argument("mesh has no faces");
  Bounds box{Vec3::Constant(std::numeric_limits<double>::infinity()),
             Vec3::Constant(-std::numeric_limits<double>::infinity())};
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) {
      if (v >= mesh.positions.size()) {
        throw std::invalid_argument("face " + std::to_string(f) + " uses vertex " + std::to_string(v) + " of " +
                                    std::to_string(mesh.positions.size()));
      }
      const Vec3& position = mesh.positions[v];
      if (!position.allFinite())
        throw std::invalid_argument("position of vertex " + std::to_string(v) + " is not finite");
      box.min = box.min.cwiseMin(position);
      box.max = box.max.cwiseMax(position);
    }
  }
  return box;
}

}  // namespace whittle::metrics
