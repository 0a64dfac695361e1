// Simplifies a mesh in two plain arrays to two plain arrays, as `whittle simplify` does.
#include <cstdio>
#include <vector>
#include <whittle/simplify/simplify.hh>

#include "torus.hh"

namespace {

/// The arrays of our program, in the form that a graphics card takes.
struct Arrays {
  std::vector<float> coordinates;  ///< x, y, z of each vertex
  std::vector<unsigned> corners;   ///< three vertex numbers of each triangle
};

Arrays some_arrays() {
  const Torus torus(48, 24);
  Arrays arrays;
  for (const auto& point : torus.points)
    for (const double x : point) arrays.coordinates.push_back(static_cast<float>(x));
  for (const auto& face : torus.faces) arrays.corners.insert(arrays.corners.end(), face.begin(), face.end());
  return arrays;
}

whittle::IndexedMesh mesh_of(const Arrays& arrays) {
  whittle::IndexedMesh mesh;
  for (std::size_t i = 0; i + 2 < arrays.coordinates.size(); i += 3)
    mesh.positions.emplace_back(arrays.coordinates[i], arrays.coordinates[i + 1], arrays.coordinates[i + 2]);
  for (std::size_t i = 0; i + 2 < arrays.corners.size(); i += 3)
    mesh.faces.push_back({arrays.corners[i], arrays.corners[i + 1], arrays.corners[i + 2]});
  return mesh;
}

Arrays arrays_of(const whittle::IndexedMesh& mesh) {
  Arrays arrays;
  for (const whittle::Vec3& point : mesh.positions)
    for (const double x : point) arrays.coordinates.push_back(static_cast<float>(x));
  for (const whittle::Triangle& face : mesh.faces)
    arrays.corners.insert(arrays.corners.end(), face.begin(), face.end());
  return arrays;
}

}  // namespace

int main() {
  const whittle::IndexedMesh mesh = mesh_of(some_arrays());

  // The target is required. The effort trades time for accuracy: fast, normal (the default) or best.
  const whittle::Simplification small =
      whittle::simplify(mesh, whittle::DecimateTarget::faces(300), whittle::Effort::best);
  for (const whittle::Warning& warning : small.result.warnings) std::printf("warning: %s\n", warning.text.c_str());

  const Arrays out = arrays_of(small.mesh);
  std::printf("%zu faces became %zu; polish lowered the error from %.5f to %.5f\n", mesh.faces.size(),
              out.corners.size() / 3, small.polish.rms_before, small.polish.rms_after);
  const bool is_reached = small.result.stop == whittle::StopReason::target && out.corners.size() == 3 * 300;
  return is_reached && small.polish.rms_after < small.polish.rms_before ? 0 : 1;
}
