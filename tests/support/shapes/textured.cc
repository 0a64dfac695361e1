// Shapes with seams.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "support/shapes/shapes.hh"
#include "whittle/core/wedges.hh"

namespace whittle::test {
namespace {

Attribute texcoords() { return {.name = "uv", .kind = AttributeKind::texcoord, .n_components = 2, .values = {}}; }

/// The side of the cube (±1)³ that the middle of a face lies on: 0 … 5.
std::size_t side_of(const Vec3& middle) {
  Eigen::Index axis = 0;
  middle.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::size_t>(axis) + (middle[axis] > 0 ? 1 : 0);
}

}  // namespace

std::array<double, 2> chart_position(std::size_t side, const Vec3& position) {
  const auto axis = static_cast<Eigen::Index>(side / 2);
  const double u = position[(axis + 1) % 3];
  const double v = position[(axis + 2) % 3];
  const bool is_mirrored = side % 2 == 0;
  return {static_cast<double>(side) + 0.4 * (is_mirrored ? -u : u), 0.3 * v};
}

IndexedMesh charted_cube(int n) {
  IndexedMesh mesh = tessellated_cube(n);
  Attribute uv = texcoords();
  for (const Triangle& face : mesh.faces) {
    const auto& [a, b, c] = face;
    const std::size_t side = side_of((mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3);
    mesh.face_groups.push_back(static_cast<Index>(side));
    for (const Index v : face) {
      mesh.wedges.push_back(static_cast<Index>(mesh.wedges.size()));
      for (const double x : chart_position(side, mesh.positions[v])) uv.values.push_back(x);
      std::array<float, 3> normal{};
      normal[side / 2] = side % 2 == 1 ? 1 : -1;
      mesh.normals.push_back(normal);
    }
  }
  mesh.attributes.push_back(uv);
  for (std::size_t side = 0; side < 6; ++side) mesh.group_names.push_back("side " + std::to_string(side));
  return mesh;
}

IndexedMesh textured_torus(int nu, int nv) {
  IndexedMesh mesh = torus(nu, nv);
  Attribute uv = texcoords();
  for (int i = 0; i <= nu; ++i) {
    for (int j = 0; j <= nv; ++j) {
      uv.values.push_back(static_cast<double>(i) / nu);
      uv.values.push_back(static_cast<double>(j) / nv);
    }
  }
  const auto share = [](double y, double x) {
    const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
    return turn < -1e-9 ? turn + 1 : turn;
  };
  const auto slot = [](double at, int n) { return static_cast<int>(std::lround(at * n)) % n; };
  for (const Triangle& face : mesh.faces) {
    std::array<int, 3> u{};
    std::array<int, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[face[k]];
      u[k] = slot(share(p.y(), p.x()), nu);
      v[k] = slot(share(p.z(), std::hypot(p.x(), p.y()) - 1), nv);
    }
    const auto unwrap = [](std::array<int, 3>& x, int n) {  // a face beside the cut ends there
      const bool is_beside = *std::max_element(x.begin(), x.end()) == n - 1;
      for (int& at : x) at = is_beside && at == 0 ? n : at;
    };
    unwrap(u, nu);
    unwrap(v, nv);
    for (std::size_t k = 0; k < 3; ++k) mesh.wedges.push_back(static_cast<Index>(u[k] * (nv + 1) + v[k]));
  }
  mesh.attributes.push_back(uv);
  return mesh;
}

IndexedMesh tiled_torus(int nu, int nv, int tile) {
  IndexedMesh mesh = textured_torus(nu, nv);
  const Attribute whole = mesh.attributes[0];
  std::vector<double>& values = mesh.attributes[0].values;
  values.clear();
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    std::array<double, 2> middle{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 2; ++i) middle[i] += whole.value(mesh.wedges[3 * f + k])[i] / 3;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 2; ++i) {
        const double n_tiles = static_cast<double>(i == 0 ? nu : nv) / tile;
        const double corner = std::floor(middle[i] * n_tiles);
        values.push_back(10 * corner + (whole.value(mesh.wedges[3 * f + k])[i] * n_tiles - corner));
      }
    }
  }
  std::iota(mesh.wedges.begin(), mesh.wedges.end(), Index{0});
  join_equal_wedges(mesh);
  return mesh;
}

IndexedMesh disc_in_square(int n) {
  IndexedMesh mesh = grid(n, n);
  for (const Triangle& face : mesh.faces) {
    const Vec3 middle = (mesh.positions[face[0]] + mesh.positions[face[1]] + mesh.positions[face[2]]) / 3;
    mesh.face_groups.push_back((middle - Vec3(n, n, 0) / 2).norm() < 0.3 * n ? 1 : 0);
  }
  return mesh;
}

double area_of_disc(const IndexedMesh& mesh) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& [a, b, c] = mesh.faces[f];
    const Vec3 normal = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    if (mesh.face_groups[f] == 1) area += normal.norm() / 2;
  }
  return area;
}

}  // namespace whittle::test
