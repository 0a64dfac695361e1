#include "shapes.hh"

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace whittle::test {
namespace {

/// A multiple of 2⁻²⁰ in [0, 1), by a hash of the number (SplitMix64).
double noise(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15U;
  number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9U;
  number = (number ^ (number >> 27)) * 0x94d049bb133111ebU;
  return static_cast<double>((number ^ (number >> 31)) >> 44) / 0x1p20;
}

/// Adds a square grid of n by n cells. \param vertex (column, row) → its number
template <class VertexAt>
void add_grid(IndexedMesh& mesh, unsigned n, const VertexAt& vertex) {
  for (unsigned row = 0; row < n; ++row) {
    for (unsigned column = 0; column < n; ++column) {
      const Index a = vertex(column, row);
      const Index b = vertex(column + 1, row);
      const Index c = vertex(column + 1, row + 1);
      const Index d = vertex(column, row + 1);
      mesh.faces.push_back({a, b, c});
      mesh.faces.push_back({a, c, d});
    }
  }
}

void append(IndexedMesh& mesh, const IndexedMesh& other, const Vec3& offset) {
  const auto first = static_cast<Index>(mesh.positions.size());
  for (const Vec3& p : other.positions) mesh.positions.push_back(p + offset);
  for (const auto& [a, b, c] : other.faces) mesh.faces.push_back({first + a, first + b, first + c});
}

}  // namespace

IndexedMesh hills(unsigned n) {
  IndexedMesh mesh;
  for (unsigned y = 0; y <= n; ++y) {
    for (unsigned x = 0; x <= n; ++x) {
      const unsigned hill = (x / 8) * 1000 + y / 8;  // and each vertex a little off it
      mesh.positions.emplace_back(x, y, 4 * noise(hill) + 0.25 * noise(1'000'000 + 1000 * y + x));
    }
  }
  add_grid(mesh, n, [n](unsigned column, unsigned row) { return (n + 1) * row + column; });
  return mesh;
}

IndexedMesh rough_cube(unsigned n) {
  IndexedMesh mesh;
  std::map<std::array<unsigned, 3>, Index> numbers;
  const auto number_of = [&](const std::array<unsigned, 3>& place) {
    const auto [found, is_new] = numbers.emplace(place, static_cast<Index>(mesh.positions.size()));
    if (is_new) {
      const auto coordinate = [&](unsigned axis) {
        return (place[axis] + 0.25 * noise(3 * mesh.positions.size() + axis)) / 64;
      };
      mesh.positions.emplace_back(coordinate(0), coordinate(1), coordinate(2));
    }
    return found->second;
  };
  for (unsigned axis = 0; axis < 3; ++axis) {
    for (const unsigned level : {0U, n}) {
      add_grid(mesh, n, [&](unsigned column, unsigned row) {
        std::array<unsigned, 3> place{};
        place[axis] = level;
        place[(axis + 1) % 3] = level == 0 ? row : column;  // counter-clockwise from outside
        place[(axis + 2) % 3] = level == 0 ? column : row;
        return number_of(place);
      });
    }
  }
  return mesh;
}

IndexedMesh two_cubes(unsigned n) {
  IndexedMesh mesh = rough_cube(n);
  append(mesh, rough_cube(n), Vec3(1.01 * n / 64, 0, 0));
  return mesh;
}

IndexedMesh crossed_sheets(unsigned n) {
  IndexedMesh mesh = hills(n);
  const Index first = static_cast<Index>(mesh.positions.size());
  for (unsigned z = 1; z <= n; ++z) {
    for (unsigned x = 0; x <= n; ++x)
      mesh.positions.emplace_back(x, n / 2, 8 + z + 0.25 * noise(2'000'000 + 1000 * z + x));
  }
  add_grid(mesh, n, [&](unsigned column, unsigned row) {
    return row == 0 ? (n + 1) * (n / 2) + column : first + (n + 1) * (row - 1) + column;
  });
  return mesh;
}

IndexedMesh painted(IndexedMesh mesh) {
  const auto n = static_cast<Index>(mesh.positions.size());
  // A wedge a vertex and chart: the first and the second half of the faces.
  Attribute uv{"uv", AttributeKind::texcoord, 2};
  std::vector<Color> colors;
  for (Index w = 0; w < 2 * n; ++w) {
    const Vec3& p = mesh.positions[w % n];
    const double shift = w < n ? 0 : 3;
    uv.values.push_back(shift + p.x() + 0.25 * p.z() * p.z());
    uv.values.push_back(p.y() + 0.5 * p.x() * p.z());
    const auto level = [](double x) { return static_cast<float>(0.5 + 0.5 * x / (1 + x * x)); };
    colors.push_back({level(p.x() * p.y()), level(4 * p.z()), level(p.x() - p.y()), 1});
  }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    for (const Index v : mesh.faces[f]) mesh.wedges.push_back(2 * f < mesh.faces.size() ? v : v + n);
  }
  mesh.colors = std::move(colors);
  mesh.attributes.push_back(std::move(uv));
  return mesh;
}

}  // namespace whittle::test
