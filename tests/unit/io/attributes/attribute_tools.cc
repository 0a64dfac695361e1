#include "attribute_tools.hh"

#include <algorithm>
#include <cmath>

namespace whittle::io::test {

std::vector<std::filesystem::path> asset_files(const std::string& folder, const std::string& extension) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  const std::filesystem::path root = std::filesystem::path(WHITTLE_TEST_ASSETS) / folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root, error)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

IndexedMesh cube_with_charts() {
  IndexedMesh mesh;
  Attribute texcoords{.name = "s,t", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}};
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    const auto first = static_cast<Index>(mesh.positions.size());
    for (int corner = 0; corner < 4; ++corner) {
      const double u = corner == 1 || corner == 2 ? 1 : -1;
      const double v = corner >= 2 ? 1 : -1;
      Vec3 position;
      position[axis] = sign;
      position[(axis + 1) % 3] = sign * u;
      position[(axis + 2) % 3] = v;
      mesh.positions.push_back(position);
      std::array<float, 3> normal{};
      normal[static_cast<std::size_t>(axis)] = static_cast<float>(sign);
      mesh.normals.push_back(normal);
      texcoords.values.push_back((side % 3 + 0.5 + 0.375 * u) / 3);
      texcoords.values.push_back((side / 3 + 0.5 + 0.375 * v) / 2);
    }
    mesh.faces.push_back({first, first + 1, first + 2});
    mesh.faces.push_back({first, first + 2, first + 3});
  }
  for (double& x : texcoords.values) x = double{static_cast<float>(x)};
  mesh.attributes.push_back(std::move(texcoords));
  return mesh;
}

IndexedMesh tube_with_seam(Index around, Index along) {
  IndexedMesh mesh;
  Attribute texcoords{.name = "s,t", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}};
  for (Index j = 0; j <= along; ++j) {
    for (Index i = 0; i <= around; ++i) {
      const double angle = 2 * 3.14159265358979 * (i % around) / around;
      mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.5 * j);
      texcoords.values.push_back(double{static_cast<float>(i) / static_cast<float>(around)});
      texcoords.values.push_back(double{static_cast<float>(j) / static_cast<float>(along)});
    }
  }
  const Index row = around + 1;
  for (Index j = 0; j < along; ++j) {
    for (Index i = 0; i < around; ++i) {
      const Index a = j * row + i;
      mesh.faces.push_back({a, a + 1, a + row + 1});
      mesh.faces.push_back({a, a + row + 1, a + row});
    }
  }
  mesh.attributes.push_back(std::move(texcoords));
  return mesh;
}

}  // namespace whittle::io::test
