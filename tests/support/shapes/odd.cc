// Shapes of several parts, non-manifold shapes, and functions that add defects to a mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "support/random.hh"
#include "support/shapes/shapes.hh"

namespace whittle::test {
namespace {

void append(IndexedMesh& mesh, const IndexedMesh& part, const Vec3& offset) {
  const auto first = static_cast<Index>(mesh.positions.size());
  for (const Vec3& p : part.positions) mesh.positions.push_back(p + offset);
  for (const auto& [a, b, c] : part.faces) mesh.faces.push_back({a + first, b + first, c + first});
}

}  // namespace

IndexedMesh joined(const IndexedMesh& a, const IndexedMesh& b) {
  IndexedMesh mesh;
  append(mesh, a, Vec3::Zero());
  append(mesh, b, Vec3::Zero());
  return mesh;
}

IndexedMesh spheres(int count, int levels, double gap) {
  const IndexedMesh one = sphere(levels);
  IndexedMesh mesh;
  for (int i = 0; i < count; ++i) append(mesh, one, Vec3((2 + gap) * i, 0, 0));
  return mesh;
}

IndexedMesh boxes(int nx, int ny, double gap) {
  const IndexedMesh one = cube();
  IndexedMesh mesh;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) append(mesh, one, Vec3((2 + gap) * i, (2 + gap) * j, 0));
  return mesh;
}

IndexedMesh bow_tie() {
  // Vertex 0 of both tetrahedra is (1, 1, 1). The second tetrahedron is the first one mirrored at that point.
  IndexedMesh mesh = tetrahedron();
  for (Index v = 1; v < 4; ++v) mesh.positions.push_back(2 * mesh.positions[0] - mesh.positions[v]);
  const auto mirrored = [](Index v) { return v == 0 ? v : v + 3; };
  for (Index f = 0; f < 4; ++f) {
    const auto [a, b, c] = mesh.faces[f];
    mesh.faces.push_back({mirrored(a), mirrored(c), mirrored(b)});
  }
  return mesh;
}

IndexedMesh three_faces_on_an_edge() {
  IndexedMesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {-0.5, 0.8, 0.5}, {-0.5, -0.8, 0.5}};
  mesh.faces = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  return mesh;
}

IndexedMesh book(int n_pages, int n_along) {
  const auto n_rows = static_cast<Index>(n_along + 1);
  const IndexedMesh page = grid(2, n_along);  // its first column is the spine
  IndexedMesh mesh;
  for (Index row = 0; row < n_rows; ++row) mesh.positions.emplace_back(0, page.positions[3 * row].y(), 0);
  for (int i = 0; i < n_pages; ++i) {
    const double angle = 2 * std::numbers::pi * i / n_pages;
    const auto first = static_cast<Index>(mesh.positions.size());
    const auto number = [&](Index v) { return v % 3 == 0 ? v / 3 : first + v / 3 * 2 + v % 3 - 1; };
    for (Index v = 0; v < page.positions.size(); ++v) {
      const Vec3& p = page.positions[v];
      if (v % 3 != 0) mesh.positions.emplace_back(p.x() * std::cos(angle), p.y(), p.x() * std::sin(angle));
    }
    for (const auto& [a, b, c] : page.faces) mesh.faces.push_back({number(a), number(b), number(c)});
  }
  return mesh;
}

IndexedMesh two_cubes_on_an_edge(int n) {
  // Moved by (2, 2, 0), the second cube's edge (-1, -1, z) lies exactly on the first cube's edge (1, 1, z).
  IndexedMesh mesh = tessellated_cube(n);
  append(mesh, tessellated_cube(n), Vec3(2, 2, 0));
  return glued(mesh);
}

IndexedMesh two_sided_leaf(Index n) {
  IndexedMesh mesh;
  const Index row = n + 1;
  for (const bool is_back : {false, true}) {
    std::vector<Index> number(std::size_t{row} * row);
    for (Index y = 0; y <= n; ++y) {
      for (Index x = 0; x <= n; ++x) {
        const bool is_rim = x == 0 || y == 0 || x == n || y == n;
        Index& v = number[y * row + x];
        v = static_cast<Index>(mesh.positions.size());
        const Vec3 p(x, y, 0.3 * std::sin(0.7 * x) * std::cos(0.5 * y));
        if (is_back && is_rim) {
          const auto same = std::find(mesh.positions.begin(), mesh.positions.end(), p);
          v = static_cast<Index>(same - mesh.positions.begin());
        } else {
          mesh.positions.push_back(p);
        }
      }
    }
    for (Index y = 0; y < n; ++y) {
      for (Index x = 0; x < n; ++x) {
        const Index a = number[y * row + x];
        const Index b = number[y * row + x + 1];
        const Index c = number[(y + 1) * row + x + 1];
        const Index d = number[(y + 1) * row + x];
        if (is_back) {
          mesh.faces.insert(mesh.faces.end(), {{a, c, b}, {a, d, c}});
        } else {
          mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {a, c, d}});
        }
      }
    }
  }
  return mesh;
}

IndexedMesh thin_wall(Index n) {
  IndexedMesh mesh = two_sided_leaf(n);
  const std::size_t n_front = std::size_t{n + 1} * (n + 1);
  for (std::size_t v = n_front; v < mesh.positions.size(); ++v) mesh.positions[v].z() -= 0.05;
  return mesh;
}

IndexedMesh pillow() {
  IndexedMesh mesh = single_triangle();
  mesh.faces.push_back({0, 2, 1});
  return mesh;
}

IndexedMesh soup(const IndexedMesh& mesh) {
  IndexedMesh result;
  for (const Triangle& face : mesh.faces) {
    const auto first = static_cast<Index>(result.positions.size());
    for (const Index v : face) result.positions.push_back(mesh.positions[v]);
    result.faces.push_back({first, first + 1, first + 2});
  }
  return result;
}

IndexedMesh glued(const IndexedMesh& mesh) {
  std::map<std::array<double, 3>, Index> vertices;
  IndexedMesh result;
  std::vector<Index> number;
  for (const Vec3& p : mesh.positions) {
    const auto [it, is_new] = vertices.try_emplace({p.x(), p.y(), p.z()}, static_cast<Index>(result.positions.size()));
    if (is_new) result.positions.push_back(p);
    number.push_back(it->second);
  }
  for (const auto& [a, b, c] : mesh.faces) result.faces.push_back({number[a], number[b], number[c]});
  return result;
}

IndexedMesh with_duplicate_faces(const IndexedMesh& mesh, int count) {
  if (count < 0 || static_cast<std::size_t>(count) > mesh.faces.size())
    throw std::invalid_argument("test shape: more duplicates than faces");
  IndexedMesh result;
  result.positions = mesh.positions;
  result.faces = mesh.faces;
  for (int f = 0; f < count; ++f) {
    Triangle copy = mesh.faces[static_cast<std::size_t>(f)];
    std::rotate(copy.begin(), copy.begin() + f % 3, copy.end());
    result.faces.push_back(copy);
  }
  return result;
}

IndexedMesh with_isolated_vertices(const IndexedMesh& mesh, int count, std::uint64_t seed) {
  Random random(seed);
  const std::size_t n_old = mesh.positions.size();
  const std::size_t n_new = n_old + static_cast<std::size_t>(count);
  std::vector<bool> is_isolated(n_new, false);
  std::fill(is_isolated.begin(), is_isolated.begin() + count, true);
  for (std::size_t i = n_new; i > 1; --i) {
    const auto j = static_cast<std::size_t>(random.below(i));
    const bool other = is_isolated[j];
    is_isolated[j] = is_isolated[i - 1];
    is_isolated[i - 1] = other;
  }
  IndexedMesh result;
  std::vector<Index> number;
  for (std::size_t v = 0; v < n_new; ++v) {
    if (is_isolated[v]) {
      result.positions.push_back(random.uniform_vector(-3, 3));
    } else {
      result.positions.push_back(mesh.positions[number.size()]);
      number.push_back(static_cast<Index>(v));
    }
  }
  for (const auto& [a, b, c] : mesh.faces) result.faces.push_back({number[a], number[b], number[c]});
  return result;
}

IndexedMesh inside_out(const IndexedMesh& mesh) {
  IndexedMesh result = mesh;
  for (Triangle& face : result.faces) std::swap(face[1], face[2]);
  for (std::size_t corner = 0; corner < result.wedges.size(); corner += 3) {
    std::swap(result.wedges[corner + 1], result.wedges[corner + 2]);
  }
  for (auto& normal : result.normals)
    for (float& x : normal) x = -x;
  return result;
}

}  // namespace whittle::test
