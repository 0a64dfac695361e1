#include "whittle/core/geometry/vertex_normals.hh"

namespace whittle {

std::vector<std::array<float, 3>> vertex_normals(const IndexedMesh& mesh, const Frame& frame) {
  std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
  for (const Triangle& face : mesh.faces) {
    const Vec3 p = frame.to_frame(mesh.positions[face[0]]);
    const Vec3 normal =
        (frame.to_frame(mesh.positions[face[1]]) - p).cross(frame.to_frame(mesh.positions[face[2]]) - p);
    for (const Index v : face) sums[v] += normal;
  }
  std::vector<std::array<float, 3>> normals(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const double largest = sums[v].cwiseAbs().maxCoeff();
    if (largest > 0 && largest < 1e-140) sums[v] /= largest;  // its square would lose digits
    const double length = sums[v].norm();
    if (length > 0) sums[v] /= length;
    normals[v] = {static_cast<float>(sums[v].x()), static_cast<float>(sums[v].y()), static_cast<float>(sums[v].z())};
  }
  return normals;
}

}  // namespace whittle
