#include "support/shapes/two_sided.hh"

namespace whittle::test {

IndexedMesh with_backs(const IndexedMesh& mesh, std::size_t count) {
  IndexedMesh result;
  result.positions = mesh.positions;
  result.faces = mesh.faces;
  for (std::size_t f = 0; f < count; ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    result.faces.push_back({b, a, c});
  }
  return result;
}

IndexedMesh with_backs(const IndexedMesh& mesh) { return with_backs(mesh, mesh.faces.size()); }

}  // namespace whittle::test
